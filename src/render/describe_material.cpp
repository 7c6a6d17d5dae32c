#include "render/describe_material.h"

#include <cmath>
#include <cstddef>

#include "optics/shader_lib.h"

namespace ribalta {
namespace {

// What the shader needs to look textures up, into a SurfaceMaterial or SurfaceLayers.
template <std::size_t N, typename Description>
void describeSlots(const std::array<SlotUse, N>& slots, const IsUploaded& isUploaded,
                   Description& result) {
    for (std::size_t t = 0; t < slots.size(); ++t) {
        if (!*slots[t].slot || !isUploaded(**slots[t].slot, slots[t].colors)) {
            continue;
        }
        const TextureSlot& slot = **slots[t].slot;
        result.flags.y |= 1 << t;
        result.flags.z |= slot.uvSet == 1 ? 1 << t : 0;
        const glm::mat3 rows = glm::transpose(slot.textureFromUv);
        result.uvRows[2 * t] = glm::vec4(rows[0], 0.0F);
        result.uvRows[2 * t + 1] = glm::vec4(rows[1], 0.0F);
    }
}

}  // namespace

std::array<SlotUse, gpu::kLayerTextures> slotsOf(const MaterialLayers& layers) {
    return {{{&layers.specularTexture, false},
             {&layers.specularColorTexture, true},
             {&layers.clearcoatTexture, false},
             {&layers.clearcoatRoughnessTexture, false},
             {&layers.clearcoatNormalTexture, false},
             {&layers.sheenColorTexture, true},
             {&layers.sheenRoughnessTexture, false},
             {&layers.anisotropyTexture, false},
             {&layers.transmissionTexture, false}}};
}

std::array<SlotUse, gpu::kMaterialTextures> slotsOf(const Material& material) {
    return {{{&material.baseColorTexture, true},
             {&material.metallicRoughnessTexture, false},
             {&material.normalTexture, false},
             {&material.occlusionTexture, false},
             {&material.emissiveTexture, true}}};
}

gpu::SurfaceLayers describeLayers(const MaterialLayers& layers, const IsUploaded& isUploaded) {
    gpu::SurfaceLayers result{};
    result.specular = glm::vec4(layers.specularColor, layers.specular);
    result.coat = glm::vec4(layers.clearcoat, layers.clearcoatRoughness,
                            layers.clearcoatNormalScale, shader::f0FromIor(double(layers.ior)));
    result.sheen = glm::vec4(layers.sheenColor, layers.sheenRoughness);
    result.anisotropy = glm::vec4(layers.anisotropy, std::cos(layers.anisotropyRotation),
                                  std::sin(layers.anisotropyRotation), layers.transmission);
    result.flags.x = layers.glossinessInSpecular ? gpu::kGlossinessFlag : 0;
    describeSlots(slotsOf(layers), isUploaded, result);
    return result;
}

gpu::SurfaceMaterial describeMaterial(const Material& material, const IsUploaded& isUploaded) {
    gpu::SurfaceMaterial result{};
    result.baseColor = material.baseColor;
    result.emission = glm::vec4(material.emission, material.alphaCutoff);
    result.factors = glm::vec4(material.metallic, material.roughness, material.normalScale,
                               material.occlusionStrength);
    result.flags.x =
        (material.unlit ? gpu::kUnlitFlag : 0) | (material.doubleSided ? gpu::kDoubleSidedFlag : 0);
    describeSlots(slotsOf(material), isUploaded, result);
    return result;
}

}  // namespace ribalta
