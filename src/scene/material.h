// Material: glTF 2.0's metallic-roughness model (section 3.9) with its texture slots.
#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>

namespace ribalta {

/// Largest emission, cd/m2: products with it still fit single precision.
inline constexpr double kMaxEmission = 1e12;

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

/// What the KHR_materials extensions add to a surface, as shaders/lib/layers.glsl draws it. As it
/// stands here it changes nothing.
struct MaterialLayers {
    float ior = 1.5F;               ///< of what is no metal; 0: reflects all
    float specular = 1.0F;          ///< 0..1
    glm::vec3 specularColor{1.0F};  ///< linear, 0 and up
    float clearcoat = 0.0F;         ///< 0..1
    float clearcoatRoughness = 0.0F;
    float clearcoatNormalScale = 1.0F;
    glm::vec3 sheenColor{0.0F};  ///< linear 0..1
    float sheenRoughness = 0.0F;
    float anisotropy = 0.0F;          ///< 0..1
    float anisotropyRotation = 0.0F;  ///< radians from the tangent, counter-clockwise
    float transmission = 0.0F;        ///< 0..1, through a thin wall
    /// The alpha of specularColorTexture is glossiness (KHR_materials_pbrSpecularGlossiness): the
    /// surface's roughness is 1 - (1 - roughness) * alpha.
    bool glossinessInSpecular = false;

    std::optional<TextureSlot> specularTexture;            ///< A
    std::optional<TextureSlot> specularColorTexture;       ///< sRGB
    std::optional<TextureSlot> clearcoatTexture;           ///< linear; R
    std::optional<TextureSlot> clearcoatRoughnessTexture;  ///< linear; G
    std::optional<TextureSlot> clearcoatNormalTexture;     ///< linear, tangent space
    std::optional<TextureSlot> sheenColorTexture;          ///< sRGB
    std::optional<TextureSlot> sheenRoughnessTexture;      ///< A
    std::optional<TextureSlot> anisotropyTexture;          ///< linear; RG direction, B strength
    std::optional<TextureSlot> transmissionTexture;        ///< linear; R
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
    std::optional<MaterialLayers> layers;  ///< only where they change something

    /// Whether light from behind comes through. Such surfaces cast no shadow.
    bool isSeeThrough() const {
        return alphaMode == AlphaMode::kBlend || (layers && layers->transmission > 0.0F);
    }
};

}  // namespace ribalta
