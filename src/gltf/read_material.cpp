#include "gltf/read_material.h"

#include <string>

#include "gltf/read_layers.h"
#include "gltf/read_texture_slot.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

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

std::string TextureTable::faultOf(std::size_t texture) const {
    return extension(element(import_.json, "textures", texture), "KHR_texture_basisu").is_null()
               ? "which has no image that can be read"
               : "which has its image as KTX2 alone (KHR_texture_basisu), which is not read; "
                 "export "
                 "it as PNG, JPEG or WebP";
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
        return readTextureSlot(holder, key, at, textures, report);
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
    readLayers(object, place, textures, material, report);
    return material;
}

int tangentUvOf(const Import& import, std::size_t index) {
    const json& object = element(import.json, "materials", index);
    const json& anisotropy = extension(object, "KHR_materials_anisotropy");
    const json& coat = extension(object, "KHR_materials_clearcoat");
    for (const json* slot :
         {&member(object, "normalTexture"), &member(anisotropy, "anisotropyTexture"),
          &member(coat, "clearcoatNormalTexture")}) {
        if (!slot->is_null()) {
            const int set = uvSetOf(*slot);
            return set >= 0 && set < kUvSets ? set : -1;
        }
    }
    return anisotropy.is_null() ? -1 : 0;
}

}  // namespace ribalta::gltf
