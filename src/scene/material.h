// Material: glTF 2.0's metallic-roughness model (section 3.9) with its texture slots.
#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>

namespace ribalta {

struct Sampler {
    enum class Filter { kNearest, kLinear };
    enum class Wrap { kRepeat, kMirroredRepeat, kClampToEdge };

    Filter magnify = Filter::kLinear;
    Filter minify = Filter::kLinear;         ///< between the texels of a level
    Filter betweenLevels = Filter::kLinear;  ///< between mip levels
    bool mipmaps = true;
    Wrap wrapS = Wrap::kRepeat;
    Wrap wrapT = Wrap::kRepeat;

    bool operator==(const Sampler&) const = default;
};

/// An image seen through a sampler. Several textures may share an image.
struct Texture {
    int image = -1;  ///< into Scene::images
    Sampler sampler;
};

/// A material's use of a texture: which, by which coordinates (KHR_texture_transform).
struct TextureSlot {
    int texture = -1;  ///< into Scene::textures
    int uvSet = 0;     ///< 0 or 1
    glm::mat3 textureFromUv{1.0F};
};

struct Material {
    enum class AlphaMode { kOpaque, kMask, kBlend };

    std::string name;
    glm::vec4 baseColor{1.0F};  ///< linear
    float metallic = 1.0F;
    float roughness = 1.0F;
    float normalScale = 1.0F;
    float occlusionStrength = 1.0F;
    glm::vec3 emission{0.0F};  ///< cd/m2 by channel: emissiveFactor * emissiveStrength
    std::optional<TextureSlot> baseColorTexture;          ///< sRGB
    std::optional<TextureSlot> metallicRoughnessTexture;  ///< linear; G roughness, B metallic
    std::optional<TextureSlot> normalTexture;             ///< linear, tangent space
    std::optional<TextureSlot> occlusionTexture;          ///< linear; R
    std::optional<TextureSlot> emissiveTexture;           ///< sRGB
    AlphaMode alphaMode = AlphaMode::kOpaque;
    float alphaCutoff = 0.5F;
    bool doubleSided = false;
    bool unlit = false;  ///< KHR_materials_unlit: base colour as luminance, no lamps
};

}  // namespace ribalta
