#include "reference/material_textures.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "optics/shader_lib.h"

namespace ribalta {
namespace {

int wrapped(int texel, int count, Sampler::Wrap mode) {
    if (mode == Sampler::Wrap::kClampToEdge) {
        return std::clamp(texel, 0, count - 1);
    }
    const int period = mode == Sampler::Wrap::kRepeat ? count : 2 * count;
    int place = texel % period;
    place += place < 0 ? period : 0;
    return place < count ? place : period - 1 - place;
}

}  // namespace

MaterialTextures::MaterialTextures(const Scene& scene)
    : scene_(scene), images_(scene.images.size()) {
    for (const Material& material : scene.materials) {
        decode(material.baseColorTexture, Meaning::kColors);
        decode(material.emissiveTexture, Meaning::kColors);
        decode(material.metallicRoughnessTexture, Meaning::kData);
        decode(material.normalTexture, Meaning::kData);
        decode(material.occlusionTexture, Meaning::kData);
        if (const std::optional<MaterialLayers>& layers = material.layers) {
            decode(layers->specularTexture, Meaning::kData);
            decode(layers->specularColorTexture, Meaning::kColors);
            decode(layers->clearcoatTexture, Meaning::kData);
            decode(layers->clearcoatRoughnessTexture, Meaning::kData);
            decode(layers->clearcoatNormalTexture, Meaning::kData);
            decode(layers->sheenColorTexture, Meaning::kColors);
            decode(layers->sheenRoughnessTexture, Meaning::kData);
            decode(layers->anisotropyTexture, Meaning::kData);
            decode(layers->transmissionTexture, Meaning::kData);
        }
    }
}

void MaterialTextures::decode(const std::optional<TextureSlot>& slot, Meaning meaning) {
    if (!slot) {
        return;
    }
    const auto index = std::size_t(scene_.textures[std::size_t(slot->texture)].image);
    const Image& image = scene_.images[index];
    std::optional<Texels>& texels = images_[index][std::size_t(meaning)];
    if (texels || image.pixels.empty()) {
        return;
    }
    texels.emplace();
    texels->width = image.width;
    texels->height = image.height;
    const std::size_t count = std::size_t(image.width) * std::size_t(image.height);
    texels->values.resize(count);
    if (image.type == Image::Type::kFloat32) {
        std::memcpy(texels->values.data(), image.pixels.data(), count * sizeof(glm::vec4));
        return;
    }
    std::array<float, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i) {
        const double value = double(i) / 255.0;
        linear[i] = float(meaning == Meaning::kColors ? shader::srgbDecodeChannel(value) : value);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto channel = [&](std::size_t c) {
            return std::to_integer<std::size_t>(image.pixels[4 * i + c]);
        };
        texels->values[i] = {linear[channel(0)], linear[channel(1)], linear[channel(2)],
                             float(channel(3)) / 255.0F};
    }
}

const MaterialTextures::Texels* MaterialTextures::find(const TextureSlot& slot,
                                                       Meaning meaning) const {
    const auto image = std::size_t(scene_.textures[std::size_t(slot.texture)].image);
    const std::optional<Texels>& texels = images_[image][std::size_t(meaning)];
    return texels ? &*texels : nullptr;
}

glm::dvec2 MaterialTextures::size(const TextureSlot& slot) const {
    const Texels* texels = find(slot, Meaning::kColors);
    return texels == nullptr ? glm::dvec2(0.0) : glm::dvec2(texels->width, texels->height);
}

glm::dvec2 MaterialTextures::coordinates(const TextureSlot& slot, const PlacedSurface& surface,
                                         std::size_t triangle, const glm::dvec3& weights) {
    const std::vector<glm::vec2>& uvs =
        slot.uvSet == 1 ? surface.primitive->uv1 : surface.primitive->uv0;
    const glm::dvec2 uv =
        uvs.empty() ? glm::dvec2(0.0) : blended(uvs, surface.corners(triangle), weights);
    return {glm::dmat3(slot.textureFromUv) * glm::dvec3(uv, 1.0)};
}

glm::dvec4 MaterialTextures::sample(const TextureSlot& slot, Meaning meaning,
                                    const PlacedSurface& surface, std::size_t triangle,
                                    const glm::dvec3& weights) const {
    const Texels* texels = find(slot, meaning);
    const glm::dvec2 uv = coordinates(slot, surface, triangle, weights);
    if (texels == nullptr || !std::isfinite(uv.x) || !std::isfinite(uv.y)) {
        return {0.0, 0.0, 0.0, 1.0};
    }
    const Sampler& sampler = scene_.textures[std::size_t(slot.texture)].sampler;
    const auto texel = [&](double column, double row) {
        const int x = wrapped(int(column), texels->width, sampler.wrapS);
        const int y = wrapped(int(row), texels->height, sampler.wrapT);
        return glm::dvec4(
            texels->values[std::size_t(y) * std::size_t(texels->width) + std::size_t(x)]);
    };
    // Far beyond any picture's repetitions nothing is left of the fraction.
    const glm::dvec2 place = glm::clamp(uv * glm::dvec2(texels->width, texels->height), -1e9, 1e9);
    if (sampler.magnify == Sampler::Filter::kNearest) {
        return texel(std::floor(place.x), std::floor(place.y));
    }
    const glm::dvec2 first = glm::floor(place - 0.5);
    const glm::dvec2 fraction = place - 0.5 - first;
    const glm::dvec4 upper =
        glm::mix(texel(first.x, first.y), texel(first.x + 1.0, first.y), fraction.x);
    const glm::dvec4 lower =
        glm::mix(texel(first.x, first.y + 1.0), texel(first.x + 1.0, first.y + 1.0), fraction.x);
    return glm::mix(upper, lower, fraction.y);
}

double MaterialTextures::alpha(const PlacedSurface& surface, std::size_t triangle,
                               const glm::dvec3& weights) const {
    const Material& material = *surface.material;
    double alpha = material.baseColor.w;
    const std::vector<glm::vec4>& colors = surface.primitive->colors;
    if (!colors.empty()) {
        alpha *= glm::clamp(blended(colors, surface.corners(triangle), weights).w, 0.0, 1.0);
    }
    if (material.baseColorTexture) {
        alpha *= sample(*material.baseColorTexture, Meaning::kColors, surface, triangle, weights).w;
    }
    return alpha;
}

}  // namespace ribalta
