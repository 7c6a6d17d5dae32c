// GpuGeometry: the vertices and indices of a scene's meshes in GPU memory.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "gl/buffer.h"
#include "render/draw_list.h"
#include "scene/scene.h"

namespace ribalta {

inline void deleteVertexArray(GLuint name) {
    glDeleteVertexArrays(1, &name);
}

/// Vertices at such multiples start where shaders may be shown a part of a buffer.
inline constexpr std::size_t kDeformedAlignment = 64;

class GpuGeometry {
  public:
    /// Uploads it. Needs a current context. The scene is not kept.
    explicit GpuGeometry(const Scene& scene);

    /// Where a primitive lies in the shared buffers.
    struct Part {
        GLenum mode = GL_TRIANGLES;
        GLsizei indexCount = 0;
        std::size_t indexOffset = 0;  ///< bytes
        GLint baseVertex = 0;
    };
    /// Where the vertices of a deformed node's primitives lie; baseVertex is a multiple of
    /// kDeformedAlignment.
    const std::vector<Part>& deformedParts(int node) const { return deformedParts_.at(node); }
    /// Positions, three floats each, and kAttributeFloats a vertex: what deformation writes.
    const Buffer& positions() const { return positions_; }
    const Buffer& attributes() const { return attributes_; }

    /// The vertex arrays of surfaces and of what casts shadows, over a list of gpu::SurfaceInstance
    /// or gpu::CasterInstance, which must outlive the draws.
    GLuint surfacesAt(const Buffer& instances) const;
    GLuint castersAt(const Buffer& instances) const;
    /// Draws an item at `count` places of that list, from the `first` on.
    void drawInstances(const DrawItem& item, std::size_t first, std::size_t count) const;

  private:
    const Part& partOf(const DrawItem& item) const;

    std::vector<std::vector<Part>> parts_;            ///< by mesh and primitive
    std::map<int, std::vector<Part>> deformedParts_;  ///< by node and primitive
    Buffer positions_;
    Buffer attributes_;
    Buffer indices_;
    Handle<deleteVertexArray> surfaceArray_;
    Handle<deleteVertexArray> casterArray_;
};

}  // namespace ribalta
