#include "render/gpu_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <set>
#include <utility>

#include <shared/deform.h>
#include <shared/slots.h>
#include <shared/surface.h>

#include "base/log.h"
#include "base/parallel_for.h"
#include "gl/counters.h"
#include "optics/shader_lib.h"
#include "render/upload_image.h"

namespace ribalta {
namespace {

// All that a vertex has besides its position, which shadow maps read alone.
struct VertexAttributes {
    glm::vec3 normal{0.0F};
    glm::vec4 tangent{0.0F};
    glm::vec2 uv0{0.0F};
    glm::vec2 uv1{0.0F};
    std::array<std::uint16_t, 4> color{65535, 65535, 65535, 65535};
};

static_assert(sizeof(VertexAttributes) == sizeof(float) * gpu::kAttributeFloats);

constexpr GLuint kPositionBinding = 0;
constexpr GLuint kAttributesBinding = 1;
constexpr GLuint kInstanceBinding = 2;

GLenum modeOf(Topology topology) {
    switch (topology) {
        case Topology::kPoints:
            return GL_POINTS;
        case Topology::kLines:
            return GL_LINES;
        case Topology::kTriangles:
            return GL_TRIANGLES;
    }
    return GL_TRIANGLES;
}

VertexAttributes attributesOf(const Primitive& primitive, std::size_t i) {
    VertexAttributes vertex;
    if (!primitive.normals.empty()) {
        vertex.normal = primitive.normals[i];
    }
    if (!primitive.tangents.empty()) {
        vertex.tangent = primitive.tangents[i];
    }
    if (!primitive.uv0.empty()) {
        vertex.uv0 = primitive.uv0[i];
    }
    if (!primitive.uv1.empty()) {
        vertex.uv1 = primitive.uv1[i];
    }
    if (!primitive.colors.empty()) {
        const glm::vec4 color = glm::clamp(primitive.colors[i], 0.0F, 1.0F) * 65535.0F + 0.5F;
        for (int c = 0; c < 4; ++c) {
            vertex.color[std::size_t(c)] = std::uint16_t(color[c]);
        }
    }
    return vertex;
}

// A primitive's vertices or indices, and how many lie before them in a buffer.
struct Placed {
    const Primitive* primitive = nullptr;
    std::size_t first = 0;
};

// Fills a buffer of `count` elements: `elementOf(primitive, i)` is one of those of a primitive.
template <typename Element, typename CountOf, typename ElementOf>
void upload(Buffer& buffer, const std::string& label, std::size_t count,
            const std::vector<Placed>& parts, const CountOf& countOf, const ElementOf& elementOf) {
    buffer.fill(label, count * sizeof(Element), [&](std::span<std::byte> bytes) {
        parallelFor(parts.size(), [&](std::size_t p) {
            const auto [primitive, first] = parts[p];
            std::byte* to = bytes.data() + first * sizeof(Element);
            for (std::size_t i = 0; i < countOf(*primitive); ++i, to += sizeof(Element)) {
                const Element element = elementOf(*primitive, i);
                std::memcpy(to, &element, sizeof element);
            }
        });
    });
}

// `instanceColumns`: four floats each, of what an instance has of its own.
GLuint makeVertexArray(const Buffer& positions, const Buffer& attributes, const Buffer& indices,
                       int instanceColumns) {
    GLuint array = 0;
    glCreateVertexArrays(1, &array);
    glVertexArrayVertexBuffer(array, kPositionBinding, positions.name(), 0, sizeof(glm::vec3));
    glVertexArrayVertexBuffer(array, kAttributesBinding, attributes.name(), 0,
                              sizeof(VertexAttributes));
    glVertexArrayElementBuffer(array, indices.name());

    const auto floats = [&](GLuint attribute, GLuint binding, int count, std::size_t offset) {
        glEnableVertexArrayAttrib(array, attribute);
        glVertexArrayAttribFormat(array, attribute, count, GL_FLOAT, GL_FALSE, GLuint(offset));
        glVertexArrayAttribBinding(array, attribute, binding);
    };
    floats(gpu::kPositionAttribute, kPositionBinding, 3, 0);
    floats(gpu::kNormalAttribute, kAttributesBinding, 3, offsetof(VertexAttributes, normal));
    floats(gpu::kTangentAttribute, kAttributesBinding, 4, offsetof(VertexAttributes, tangent));
    floats(gpu::kUv0Attribute, kAttributesBinding, 2, offsetof(VertexAttributes, uv0));
    floats(gpu::kUv1Attribute, kAttributesBinding, 2, offsetof(VertexAttributes, uv1));
    glEnableVertexArrayAttrib(array, gpu::kColorAttribute);
    glVertexArrayAttribFormat(array, gpu::kColorAttribute, 4, GL_UNSIGNED_SHORT, GL_TRUE,
                              GLuint(offsetof(VertexAttributes, color)));
    glVertexArrayAttribBinding(array, gpu::kColorAttribute, kAttributesBinding);
    for (int column = 0; column < instanceColumns; ++column) {
        floats(GLuint(gpu::kInstanceAttribute + column), kInstanceBinding, 4,
               std::size_t(column) * sizeof(glm::vec4));
    }
    glVertexArrayBindingDivisor(array, kInstanceBinding, 1);
    return array;
}

// A material's texture slots in the order of shared/surface.h; which of them hold colours.
struct SlotUse {
    const std::optional<TextureSlot>* slot;
    bool colors;
};

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

// Whether the picture of a slot that is used is on the GPU.
using IsUploaded = std::function<bool(const TextureSlot& slot, bool colors)>;

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

GpuScene::GpuScene(const Scene& scene) {
    uploadGeometry(scene);
    uploadMaterials(scene);
}

void GpuScene::uploadGeometry(const Scene& scene) {
    std::vector<Placed> vertices;
    std::vector<Placed> indices;
    std::size_t vertexCount = 0;
    std::size_t indexCount = 0;
    const auto placeVertices = [&](const Primitive& primitive) {
        const std::size_t first = vertexCount;
        vertices.push_back({&primitive, first});
        vertexCount += primitive.positions.size();
        return first;
    };
    // Where those lie that need to be there but once; vertices, of what is drawn at rest.
    std::map<int, std::size_t> sharedIndices;
    std::map<int, std::size_t> sharedVertices;
    const auto placeOnce = [](std::map<int, std::size_t>& shared, int number, const auto& place) {
        const auto known = number < 0 ? shared.end() : shared.find(number);
        if (known != shared.end()) {
            return known->second;
        }
        const std::size_t first = place();
        if (number >= 0) {
            shared.emplace(number, first);
        }
        return first;
    };
    const auto placeIndices = [&](const Primitive& primitive) {
        return placeOnce(sharedIndices, primitive.sharedIndices, [&] {
            indices.push_back({&primitive, indexCount});
            return std::exchange(indexCount, indexCount + primitive.indices.size());
        });
    };
    // Meshes that are drawn deformed alone need no vertices of their own; those that no node has
    // may be given to one later.
    std::vector<bool> isOfNode(scene.meshes.size(), false);
    std::vector<bool> isDrawnAtRest(scene.meshes.size(), false);
    for (const Node& node : scene.nodes) {
        if (node.mesh >= 0) {
            isOfNode[std::size_t(node.mesh)] = true;
            isDrawnAtRest[std::size_t(node.mesh)] =
                isDrawnAtRest[std::size_t(node.mesh)] || node.deformer < 0;
        }
    }
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        std::vector<Geometry>& list = geometry_.emplace_back();
        for (const Primitive& primitive : scene.meshes[m].primitives) {
            Geometry& geometry = list.emplace_back();
            geometry.mode = modeOf(primitive.topology);
            geometry.indexCount = GLsizei(primitive.indices.size());
            geometry.indexOffset = placeIndices(primitive) * sizeof(std::uint32_t);
            if (isDrawnAtRest[m] || !isOfNode[m]) {
                geometry.baseVertex = GLint(placeOnce(sharedVertices, primitive.sharedVertices,
                                                      [&] { return placeVertices(primitive); }));
            }
        }
    }
    for (const Deformer& deformer : scene.deformers) {
        const auto mesh = std::size_t(scene.nodes[std::size_t(deformer.node)].mesh);
        std::vector<Geometry>& list = deformedGeometry_[deformer.node];
        list = geometry_[mesh];
        for (std::size_t p = 0; p < list.size(); ++p) {
            vertexCount =
                (vertexCount + kDeformedAlignment - 1) / kDeformedAlignment * kDeformedAlignment;
            list[p].baseVertex = GLint(placeVertices(scene.meshes[mesh].primitives[p]));
        }
    }

    const auto vertexCountOf = [](const Primitive& part) { return part.positions.size(); };
    upload<glm::vec3>(positions_, "positions", vertexCount, vertices, vertexCountOf,
                      [](const Primitive& part, std::size_t i) { return part.positions[i]; });
    upload<VertexAttributes>(attributes_, "vertex attributes", vertexCount, vertices, vertexCountOf,
                             attributesOf);
    upload<std::uint32_t>(
        indices_, "indices", indexCount, indices,
        [](const Primitive& part) { return part.indices.size(); },
        [](const Primitive& part, std::size_t i) { return part.indices[i]; });
    const auto arrayFor = [&](std::size_t instanceBytes) {
        return Handle<deleteVertexArray>(makeVertexArray(positions_, attributes_, indices_,
                                                         int(instanceBytes / sizeof(glm::vec4))));
    };
    surfaceArray_ = arrayFor(sizeof(gpu::SurfaceInstance));
    casterArray_ = arrayFor(sizeof(gpu::CasterInstance));
}

GLuint GpuScene::surfacesAt(const Buffer& instances) const {
    glVertexArrayVertexBuffer(surfaceArray_.name(), kInstanceBinding, instances.name(), 0,
                              sizeof(gpu::SurfaceInstance));
    return surfaceArray_.name();
}

GLuint GpuScene::castersAt(const Buffer& instances) const {
    glVertexArrayVertexBuffer(casterArray_.name(), kInstanceBinding, instances.name(), 0,
                              sizeof(gpu::CasterInstance));
    return casterArray_.name();
}

void GpuScene::drawInstances(const DrawItem& item, std::size_t first, std::size_t count) const {
    const Geometry& at = geometry(item);
    glDrawElementsInstancedBaseVertexBaseInstance(at.mode, at.indexCount, GL_UNSIGNED_INT,
                                                  reinterpret_cast<const void*>(at.indexOffset),
                                                  GLsizei(count), at.baseVertex, GLuint(first));
    ++glCounters().drawCalls;
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

std::function<bool(const TextureSlot&, bool)> GpuScene::isUploadedOf(const Scene& scene) const {
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
