#include "render/gpu_scene.h"

#include <set>

#include <shared/slots.h>
#include <shared/surface.h>

#include "render/upload_image.h"

namespace ribalta {
namespace {

GLuint makeSampler(const Sampler& sampler) {
    const auto wrap = [](Sampler::Wrap mode) {
        switch (mode) {
            case Sampler::Wrap::kRepeat:
                return GL_REPEAT;
            case Sampler::Wrap::kMirroredRepeat:
                return GL_MIRRORED_REPEAT;
            case Sampler::Wrap::kClampToEdge:
                return GL_CLAMP_TO_EDGE;
        }
        return GL_REPEAT;
    };
    const bool near = sampler.minify == Sampler::Filter::kNearest;
    const bool sharp = sampler.betweenLevels == Sampler::Filter::kNearest;
    GLint minify = near ? GL_NEAREST : GL_LINEAR;
    if (sampler.mipmaps) {
        minify = near ? (sharp ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_LINEAR)
                      : (sharp ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
    }
    GLuint name = 0;
    glCreateSamplers(1, &name);
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, minify);
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER,
                        sampler.magnify == Sampler::Filter::kNearest ? GL_NEAREST : GL_LINEAR);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, wrap(sampler.wrapS));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, wrap(sampler.wrapT));
    return name;
}

}  // namespace

GpuScene::GpuScene(const Scene& scene) : geometry_(scene) {
    uploadMaterials(scene);
}

void GpuScene::usePictures(const Scene& scene) {
    uploadMaterials(scene);
}

void GpuScene::uploadMaterials(const Scene& scene) {
    samplers_.clear();
    layerIndices_.clear();
    for (const Texture& texture : scene.textures) {
        samplers_.emplace_back(makeSampler(texture.sampler));
    }
    std::vector<gpu::SurfaceLayers> layers;
    const auto useAll = [&](const auto& slots) {
        for (const SlotUse& use : slots) {
            if (*use.slot) {
                useTexture(scene, **use.slot, use.colors);
            }
        }
    };
    for (const Material& material : scene.materials) {
        useAll(slotsOf(material));
        layerIndices_.push_back(material.layers ? int(layers.size()) : -1);
        if (material.layers) {
            useAll(slotsOf(*material.layers));
            layers.push_back(describeLayers(*material.layers, isUploadedOf(scene)));
        }
    }
    if (!layers.empty()) {
        layers_.write("surface layers", bytesOf(layers));
    }
    layerIndices_.push_back(-1);
    useMaterials(scene);
}

IsUploaded GpuScene::isUploadedOf(const Scene& scene) const {
    return [&](const TextureSlot& slot, bool colors) {
        return images_.contains({scene.textures[std::size_t(slot.texture)].image, colors});
    };
}

void GpuScene::useMaterials(const Scene& scene) {
    std::vector<gpu::SurfaceMaterial> materials;
    hasTextures_.clear();
    const IsUploaded isUploaded = isUploadedOf(scene);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        materials.push_back(describeMaterial(scene.materials[i], isUploaded));
        hasTextures_.push_back(materials.back().flags.y != 0);
        if (scene.materials[i].layers) {
            materials.back().flags.w = layerIndices_[i];
        }
    }
    defaultMaterial_ = int(materials.size());
    materials.push_back(describeMaterial(Material{}, isUploaded));
    hasTextures_.push_back(false);
    materials_.write("materials", spreadForUniforms(materials));
}

void GpuScene::useTexture(const Scene& scene, const TextureSlot& slot, bool colors) {
    const int image = scene.textures[std::size_t(slot.texture)].image;
    const Image& pixels = scene.images[std::size_t(image)];
    const std::pair<int, bool> key(image, colors);
    if (!pixels.pixels.empty() && !images_.contains(key)) {
        images_.emplace(key, uploadImage(pixels, colors));
    }
}

void GpuScene::bindMaterial(const Scene& scene, const DrawItem& item) const {
    materials_.bindUniform(gpu::kMaterialSlot, materialIndex(item));
    const auto bindAll = [&](const auto& slots, int firstUnit) {
        for (std::size_t t = 0; t < slots.size(); ++t) {
            if (!*slots[t].slot) {
                continue;
            }
            const auto texture = std::size_t((*slots[t].slot)->texture);
            const auto found =
                images_.find(std::pair(scene.textures[texture].image, slots[t].colors));
            const auto unit = GLuint(firstUnit + int(t));
            glBindTextureUnit(unit, found == images_.end() ? 0 : found->second.name());
            glBindSampler(unit, samplers_[texture].name());
        }
    };
    const Material& material = materialOf(scene, item);
    bindAll(slotsOf(material), gpu::kMaterialTexturesUnit);
    if (hasLayers(item)) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kSurfaceLayersSlot, layers_.name());
        bindAll(slotsOf(*material.layers), gpu::kLayerTexturesUnit);
    }
}

void GpuScene::useLightMaps(const Scene& scene, const std::vector<int>& spots) {
    std::set<int> given;
    for (const SpotLight& lamp : scene.spotLights) {
        if (lamp.lightMap) {
            given.insert(lamp.lightMap->image);
        }
    }
    const std::size_t gone = std::erase_if(
        lightMapLayers_, [&](const auto& known) { return !given.contains(known.first); });
    if (gone > 0) {
        int layer = 0;
        for (auto& known : lightMapLayers_) {
            known.second = layer++;
        }
    }
    const std::size_t before = lightMapLayers_.size();
    for (const int spot : spots) {
        const SpotLight& lamp = scene.spotLights[std::size_t(spot)];
        if (lamp.lightMap) {
            lightMapLayers_.emplace(lamp.lightMap->image, int(lightMapLayers_.size()));
        }
    }
    if (lightMapLayers_.size() == before && gone == 0) {
        return;
    }
    if (lightMapLayers_.empty()) {
        lightMaps_ = {};
        return;
    }
    // Layers have one size and number, so that a new one needs them all anew.
    std::vector<const Image*> pictures(lightMapLayers_.size());
    for (const auto& [image, layer] : lightMapLayers_) {
        pictures[std::size_t(layer)] = &scene.images[std::size_t(image)];
    }
    lightMaps_ = uploadSquareLayers("light maps", pictures);
}

int GpuScene::lightMapLayer(const SpotLight& lamp) const {
    return lamp.lightMap ? lightMapLayers_.at(lamp.lightMap->image) : -1;
}

}  // namespace ribalta
