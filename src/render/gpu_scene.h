// GpuScene: the scene's geometry, materials and pictures in GPU memory. Made once a scene; knows
// nothing of cameras and frames.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "gl/buffer.h"
#include "gl/sampler.h"
#include "gl/texture.h"
#include "render/describe_material.h"
#include "render/draw_list.h"
#include "render/gpu_geometry.h"
#include "scene/scene.h"

namespace ribalta {

class GpuScene {
  public:
    /// Uploads what the scene draws, but for light maps. Needs a current context. The scene is not
    /// kept.
    explicit GpuScene(const Scene& scene);

    const GpuGeometry& geometry() const { return geometry_; }
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
    void uploadMaterials(const Scene& scene);
    void useTexture(const Scene& scene, const TextureSlot& slot, bool colors);
    /// Whether the picture of a material's slot, of colours or not, is there.
    IsUploaded isUploadedOf(const Scene& scene) const;

    GpuGeometry geometry_;
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
