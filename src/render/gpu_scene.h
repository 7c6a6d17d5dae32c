// GpuScene: the scene's geometry, materials and pictures in GPU memory. Made once a scene; knows
// nothing of cameras and frames.
#pragma once

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "gl/buffer.h"
#include "gl/sampler.h"
#include "gl/texture.h"
#include "render/draw_list.h"
#include "scene/scene.h"

namespace ribalta {

inline void deleteVertexArray(GLuint name) {
    glDeleteVertexArrays(1, &name);
}

/// Vertices at such multiples start where shaders may be shown a part of a buffer.
inline constexpr std::size_t kDeformedAlignment = 64;

class GpuScene {
  public:
    /// Uploads what the scene draws, but for light maps. Needs a current context. The scene is not
    /// kept.
    explicit GpuScene(const Scene& scene);

    /// Where a primitive's geometry lies in the shared buffers.
    struct Geometry {
        GLenum mode = GL_TRIANGLES;
        GLsizei indexCount = 0;
        std::size_t indexOffset = 0;  ///< bytes
        GLint baseVertex = 0;
    };

    const Geometry& geometry(const DrawItem& item) const {
        const auto own = deformedGeometry_.find(item.node);
        const std::vector<Geometry>& list =
            own == deformedGeometry_.end() ? geometry_[std::size_t(item.mesh)] : own->second;
        return list[std::size_t(item.primitive)];
    }
    /// Where the vertices of a deformed node's primitives lie; baseVertex is a multiple of
    /// kDeformedAlignment.
    const std::vector<Geometry>& deformedGeometry(int node) const {
        return deformedGeometry_.at(node);
    }
    /// Positions, three floats each, and kAttributeFloats a vertex: what deformation writes.
    const Buffer& positions() const { return positions_; }
    const Buffer& attributes() const { return attributes_; }
    /// The vertex arrays of surfaces and of what casts shadows, over a list of gpu::SurfaceInstance
    /// or gpu::CasterInstance, which must outlive the draws.
    GLuint surfacesAt(const Buffer& instances) const;
    GLuint castersAt(const Buffer& instances) const;
    /// Draws an item's geometry at `count` places of that list, from the `first` on.
    void drawInstances(const DrawItem& item, std::size_t first, std::size_t count) const;
    /// Whether it is drawn with layers (MaterialLayers), which bindMaterial binds.
    bool hasLayers(const DrawItem& item) const {
        return layerIndices_[std::size_t(materialIndex(item))] >= 0;
    }
    bool hasTextures(const DrawItem& item) const {
        return hasTextures_[std::size_t(materialIndex(item))];
    }
    /// Binds an item's material to its slot and the material's pictures to their units.
    void bindMaterial(const Scene& scene, const DrawItem& item) const;

    /// Uploads pictures that the scene has got since; their pixels are not looked at again.
    /// Materials are drawn without those pictures that never had any.
    void usePictures(const Scene& scene);

    /// Uploads the numbers of materials that have changed since; their pictures and layers stay.
    void useMaterials(const Scene& scene);

    /// Uploads those light maps of these spots, by index in the scene, that are not there yet, and
    /// lets go of those that no lamp of the scene has any more.
    void useLightMaps(const Scene& scene, const std::vector<int>& spots);
    /// The light maps in use, one a layer; none where no lamp in use has one.
    const Texture2D& lightMaps() const { return lightMaps_; }
    /// Layer of the light map of a lamp in use, -1 without one.
    int lightMapLayer(const SpotLight& lamp) const;

  private:
    int materialIndex(const DrawItem& item) const {
        return item.material < 0 ? defaultMaterial_ : item.material;
    }
    void uploadGeometry(const Scene& scene);
    void uploadMaterials(const Scene& scene);
    void useTexture(const Scene& scene, const TextureSlot& slot, bool colors);
    /// Whether the picture of a material's slot, of colours or not, is there.
    std::function<bool(const TextureSlot&, bool)> isUploadedOf(const Scene& scene) const;

    std::vector<std::vector<Geometry>> geometry_;            ///< by mesh and primitive
    std::map<int, std::vector<Geometry>> deformedGeometry_;  ///< by node and primitive
    Handle<deleteVertexArray> surfaceArray_;
    Handle<deleteVertexArray> casterArray_;
    Buffer positions_;
    Buffer attributes_;
    Buffer indices_;
    Buffer materials_;
    Buffer layers_;                  ///< of those materials that have any
    std::vector<int> layerIndices_;  ///< by material index; -1 without
    int defaultMaterial_ = 0;
    std::vector<bool> hasTextures_;                     ///< by material index
    std::map<std::pair<int, bool>, Texture2D> images_;  ///< by image and whether sRGB-encoded
    std::vector<Handle<deleteSampler>> samplers_;       ///< by texture
    Texture2D lightMaps_;
    std::map<int, int> lightMapLayers_;  ///< by image
};

}  // namespace ribalta
