#include "render/gpu_geometry.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <utility>

#include <shared/deform.h>
#include <shared/slots.h>
#include <shared/surface.h>

#include "base/parallel_for.h"
#include "gl/counters.h"

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
void uploadParts(Buffer& buffer, const std::string& label, std::size_t count,
                 const std::vector<Placed>& parts, const CountOf& countOf,
                 const ElementOf& elementOf) {
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

// Where what is to be uploaded will lie.
class Placer {
  public:
    // Returns how many vertices lie before the primitive's.
    std::size_t placeVertices(const Primitive& primitive) {
        vertices_.push_back({&primitive, vertexCount_});
        return std::exchange(vertexCount_, vertexCount_ + primitive.positions.size());
    }
    // The same, of what is drawn at rest: equal ones are there but once, as are indices.
    std::size_t placeRestVertices(const Primitive& primitive) {
        return placeOnce(sharedVertices_, primitive.sharedVertices,
                         [&] { return placeVertices(primitive); });
    }
    std::size_t placeIndices(const Primitive& primitive) {
        return placeOnce(sharedIndices_, primitive.sharedIndices, [&] {
            indices_.push_back({&primitive, indexCount_});
            return std::exchange(indexCount_, indexCount_ + primitive.indices.size());
        });
    }
    void alignVertices(std::size_t count) {
        vertexCount_ = (vertexCount_ + count - 1) / count * count;
    }

    void upload(Buffer& positions, Buffer& attributes, Buffer& indices) const {
        const auto verticesOf = [](const Primitive& part) { return part.positions.size(); };
        uploadParts<glm::vec3>(
            positions, "positions", vertexCount_, vertices_, verticesOf,
            [](const Primitive& part, std::size_t i) { return part.positions[i]; });
        uploadParts<VertexAttributes>(attributes, "vertex attributes", vertexCount_, vertices_,
                                      verticesOf, attributesOf);
        uploadParts<std::uint32_t>(
            indices, "indices", indexCount_, indices_,
            [](const Primitive& part) { return part.indices.size(); },
            [](const Primitive& part, std::size_t i) { return part.indices[i]; });
    }

  private:
    // `number`: of what is shared; below 0 where nothing is.
    template <typename Place>
    static std::size_t placeOnce(std::map<int, std::size_t>& shared, int number,
                                 const Place& place) {
        const auto known = number < 0 ? shared.end() : shared.find(number);
        if (known != shared.end()) {
            return known->second;
        }
        const std::size_t first = place();
        if (number >= 0) {
            shared.emplace(number, first);
        }
        return first;
    }

    std::vector<Placed> vertices_;
    std::vector<Placed> indices_;
    std::size_t vertexCount_ = 0;
    std::size_t indexCount_ = 0;
    std::map<int, std::size_t> sharedVertices_;
    std::map<int, std::size_t> sharedIndices_;
};

// By mesh: whether it is drawn as it rests. Meshes that are drawn deformed alone need no vertices
// of their own; those that no node has may be given to one later.
std::vector<bool> findDrawnAtRest(const Scene& scene) {
    std::vector<bool> isOfNode(scene.meshes.size(), false);
    std::vector<bool> isAtRest(scene.meshes.size(), false);
    for (const Node& node : scene.nodes) {
        if (node.mesh >= 0) {
            const auto mesh = std::size_t(node.mesh);
            isOfNode[mesh] = true;
            isAtRest[mesh] = isAtRest[mesh] || node.deformer < 0;
        }
    }
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        isAtRest[m] = isAtRest[m] || !isOfNode[m];
    }
    return isAtRest;
}

}  // namespace

GpuGeometry::GpuGeometry(const Scene& scene) {
    Placer placer;
    const std::vector<bool> isAtRest = findDrawnAtRest(scene);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        std::vector<Part>& parts = parts_.emplace_back();
        for (const Primitive& primitive : scene.meshes[m].primitives) {
            Part& part = parts.emplace_back();
            part.mode = modeOf(primitive.topology);
            part.indexCount = GLsizei(primitive.indices.size());
            part.indexOffset = placer.placeIndices(primitive) * sizeof(std::uint32_t);
            part.baseVertex = isAtRest[m] ? GLint(placer.placeRestVertices(primitive)) : 0;
        }
    }
    for (const Deformer& deformer : scene.deformers) {
        const auto mesh = std::size_t(scene.nodes[std::size_t(deformer.node)].mesh);
        std::vector<Part>& parts = deformedParts_[deformer.node];
        parts = parts_[mesh];
        for (std::size_t p = 0; p < parts.size(); ++p) {
            placer.alignVertices(kDeformedAlignment);
            parts[p].baseVertex = GLint(placer.placeVertices(scene.meshes[mesh].primitives[p]));
        }
    }
    placer.upload(positions_, attributes_, indices_);

    const auto arrayFor = [&](std::size_t instanceBytes) {
        return Handle<deleteVertexArray>(makeVertexArray(positions_, attributes_, indices_,
                                                         int(instanceBytes / sizeof(glm::vec4))));
    };
    surfaceArray_ = arrayFor(sizeof(gpu::SurfaceInstance));
    casterArray_ = arrayFor(sizeof(gpu::CasterInstance));
}

const GpuGeometry::Part& GpuGeometry::partOf(const DrawItem& item) const {
    const auto deformed = deformedParts_.find(item.node);
    const std::vector<Part>& parts =
        deformed == deformedParts_.end() ? parts_[std::size_t(item.mesh)] : deformed->second;
    return parts[std::size_t(item.primitive)];
}

GLuint GpuGeometry::surfacesAt(const Buffer& instances) const {
    glVertexArrayVertexBuffer(surfaceArray_.name(), kInstanceBinding, instances.name(), 0,
                              sizeof(gpu::SurfaceInstance));
    return surfaceArray_.name();
}

GLuint GpuGeometry::castersAt(const Buffer& instances) const {
    glVertexArrayVertexBuffer(casterArray_.name(), kInstanceBinding, instances.name(), 0,
                              sizeof(gpu::CasterInstance));
    return casterArray_.name();
}

void GpuGeometry::drawInstances(const DrawItem& item, std::size_t first, std::size_t count) const {
    const Part& part = partOf(item);
    glDrawElementsInstancedBaseVertexBaseInstance(part.mode, part.indexCount, GL_UNSIGNED_INT,
                                                  reinterpret_cast<const void*>(part.indexOffset),
                                                  GLsizei(count), part.baseVertex, GLuint(first));
    ++glCounters().drawCalls;
}

}  // namespace ribalta
