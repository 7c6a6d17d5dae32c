#include "gltf/read_material.h"

#include <cmath>
#include <optional>
#include <string>

#include "gltf/bad_input.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// A texture coordinate set beyond two is not read; a slot that asks for one is left out.
constexpr int kUvSets = 2;

double numberOr(const json& object, const char* key, double otherwise) {
    const json& value = member(object, key);
    return value.is_number() ? value.get<double>() : otherwise;
}

// The set of coordinates a slot is looked up with: KHR_texture_transform may override it.
int uvSetOf(const json& slot) {
    const json& moved = member(extension(slot, "KHR_texture_transform"), "texCoord");
    const json& plain = member(slot, "texCoord");
    const json& chosen = moved.is_number_integer() ? moved : plain;
    return chosen.is_number_integer() ? chosen.get<int>() : 0;
}

bool readPair(const json& object, const char* key, glm::vec2& pair, const Place& place,
              Report& report) {
    const json& value = member(object, key);
    if (value.is_null()) {
        return true;
    }
    if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number()) {
        report.repaired(place.at(key), "is no pair of numbers; the default is used");
        return false;
    }
    pair = {value[0].get<float>(), value[1].get<float>()};
    return true;
}

// KHR_texture_transform: translation * rotation * scale.
glm::mat3 readTransform(const json& slot, const Place& slotPlace, Report& report) {
    const json& transform = extension(slot, "KHR_texture_transform");
    const Place place = slotPlace.at("extensions").at("KHR_texture_transform");
    glm::vec2 offset(0.0F);
    glm::vec2 scale(1.0F);
    readPair(transform, "offset", offset, place, report);
    readPair(transform, "scale", scale, place, report);
    const double rotation = numberOr(transform, "rotation", 0.0);
    const auto c = float(std::cos(rotation));
    const auto s = float(std::sin(rotation));
    const glm::mat3 result(glm::vec3(c * scale.x, -s * scale.x, 0.0F),
                           glm::vec3(s * scale.y, c * scale.y, 0.0F), glm::vec3(offset, 1.0F));
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            if (!std::isfinite(result[column][row])) {
                report.repaired(place, "is not finite; the texture is drawn unmoved");
                return glm::mat3(1.0F);
            }
        }
    }
    return result;
}

std::optional<TextureSlot> readSlot(const json& holder, const char* key, const Place& holderPlace,
                                    TextureTable& textures, Report& report) {
    const json& source = member(holder, key);
    if (source.is_null()) {
        return std::nullopt;
    }
    const Place place = holderPlace.at(key);
    TextureSlot slot;
    slot.uvSet = uvSetOf(source);
    if (slot.uvSet < 0 || slot.uvSet >= kUvSets) {
        report.ignored(place, "uses TEXCOORD_" + std::to_string(slot.uvSet) +
                                  ", only 0 and 1 are read; the texture is not drawn");
        return std::nullopt;
    }
    slot.texture = textures.use(source["index"].get<std::size_t>());
    if (slot.texture < 0) {
        report.ignored(place, "uses texture " + source["index"].dump() +
                                  ", which has no image that can be read; it is not drawn");
        return std::nullopt;
    }
    slot.textureFromUv = readTransform(source, place, report);
    return slot;
}

Sampler readSampler(const tinygltf::Sampler& source) {
    Sampler sampler;
    const auto wrap = [](int mode) {
        return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? Sampler::Wrap::kClampToEdge
               : mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Sampler::Wrap::kMirroredRepeat
                                                               : Sampler::Wrap::kRepeat;
    };
    sampler.wrapS = wrap(source.wrapS);
    sampler.wrapT = wrap(source.wrapT);
    const auto nearest = Sampler::Filter::kNearest;
    if (source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) {
        sampler.magnify = nearest;
    }
    const int min = source.minFilter;
    if (min == TINYGLTF_TEXTURE_FILTER_NEAREST ||
        min == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
        min == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR) {
        sampler.minify = nearest;
    }
    if (min == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
        min == TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST) {
        sampler.betweenLevels = nearest;
    }
    sampler.mipmaps =
        min != TINYGLTF_TEXTURE_FILTER_NEAREST && min != TINYGLTF_TEXTURE_FILTER_LINEAR;
    return sampler;
}

}  // namespace

int TextureTable::useImageOf(std::size_t texture) {
    // The WebP of EXT_texture_webp stands for the plain source where there is one.
    const json& webp =
        member(extension(element(import_.json, "textures", texture), "EXT_texture_webp"), "source");
    const std::size_t count = member(import_.json, "images").size();
    if (webp.is_number_integer() && webp >= 0 && webp < count) {
        return images_.useImage(webp.get<std::size_t>());
    }
    const int source = import_.model.textures.at(texture).source;
    return source < 0 ? -1 : images_.useImage(std::size_t(source));
}

int TextureTable::use(std::size_t texture) {
    const auto found = known_.find(texture);
    if (found != known_.end()) {
        return found->second;
    }
    Texture result;
    result.image = useImageOf(texture);
    int index = -1;
    if (result.image >= 0) {
        const int sampler = import_.model.textures[texture].sampler;
        if (sampler >= 0) {
            result.sampler = readSampler(import_.model.samplers[std::size_t(sampler)]);
        }
        index = int(textures_.size());
        textures_.push_back(result);
    }
    known_.emplace(texture, index);
    return index;
}

Material readMaterial(const Import& import, std::size_t index, TextureTable& textures,
                      Report& report) {
    const tinygltf::Material& source = import.model.materials.at(index);
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    const json& object = element(import.json, "materials", index);
    const json& pbrObject = member(object, "pbrMetallicRoughness");
    const Place place = import.file.at("materials").at(index);
    const Place pbrPlace = place.at("pbrMetallicRoughness");

    Material material;
    material.name = source.name;
    for (int c = 0; c < 4; ++c) {
        material.baseColor[c] = float(pbr.baseColorFactor[std::size_t(c)]);
    }
    material.metallic = float(pbr.metallicFactor);
    material.roughness = float(pbr.roughnessFactor);
    material.normalScale = float(source.normalTexture.scale);
    material.occlusionStrength = float(source.occlusionTexture.strength);
    const double strength =
        numberOr(extension(object, "KHR_materials_emissive_strength"), "emissiveStrength", 1.0);
    for (int c = 0; c < 3; ++c) {
        material.emission[c] = float(source.emissiveFactor[std::size_t(c)] * strength);
    }
    const auto slot = [&](const json& holder, const char* key, const Place& at) {
        return readSlot(holder, key, at, textures, report);
    };
    material.baseColorTexture = slot(pbrObject, "baseColorTexture", pbrPlace);
    material.metallicRoughnessTexture = slot(pbrObject, "metallicRoughnessTexture", pbrPlace);
    material.normalTexture = slot(object, "normalTexture", place);
    material.occlusionTexture = slot(object, "occlusionTexture", place);
    material.emissiveTexture = slot(object, "emissiveTexture", place);
    material.alphaMode = source.alphaMode == "MASK"    ? Material::AlphaMode::kMask
                         : source.alphaMode == "BLEND" ? Material::AlphaMode::kBlend
                                                       : Material::AlphaMode::kOpaque;
    material.alphaCutoff = float(source.alphaCutoff);
    material.doubleSided = source.doubleSided;
    material.unlit = !extension(object, "KHR_materials_unlit").is_null();
    return material;
}

int normalMapUvOf(const Import& import, std::size_t index) {
    const json& slot = member(element(import.json, "materials", index), "normalTexture");
    if (slot.is_null()) {
        return -1;
    }
    const int set = uvSetOf(slot);
    return set >= 0 && set < kUvSets ? set : -1;
}

}  // namespace ribalta::gltf
