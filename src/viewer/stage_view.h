// StageView: a scene with a look on it, and its picture. What the window shows; knows no window.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/file_cache.h"
#include "gltf/load_gltf.h"
#include "look/apply_look.h"
#include "look/look.h"
#include "render/renderer.h"

namespace ribalta {

class StageView {
  public:
    /// Uploads the scene. Needs a current context, now and whenever it draws. `cache` keeps the
    /// sky's tables and may be null; it must outlive the view.
    StageView(LoadedScene loaded, std::filesystem::path path, const FileCache* cache);
    StageView(const StageView&) = delete;
    StageView& operator=(const StageView&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// As the look leaves it.
    const Scene& scene() const { return loaded_.scene; }
    const Report& report() const { return loaded_.report; }
    const std::vector<LampId>& lamps() const { return lamps_; }
    const Bounds& bounds() const { return bounds_; }
    /// The file, the pictures beside it, and those that the look gives to lamps.
    std::vector<std::filesystem::path> files() const;
    /// What the file itself says of a lamp, which a look may change.
    double intensityInFile(const LampId& lamp) const { return intensityOf(asLoaded_, lamp); }

    /// Of the animation that the look plays, or of all together.
    double durationSeconds(const Look& look) const;
    /// A camera as the scene is posed: see posedCamera.
    Camera posed(const Camera& camera) const { return posedCamera(scene(), camera); }
    /// The scene's first camera, posed, or one that frames the scene where it has none.
    Camera homeCamera(double aspectRatio) const;

    /// Poses the scene at the look's time and brings the look's lamps to it. Throws
    /// Error(kBadInput) where a light map cannot be read; the lamps are as the file has them then,
    /// but for those before it.
    void bring(const Look& look);
    /// Whether a file is a light map that the look gives to a lamp, and its new version, to be
    /// brought again. Throws Error(kBadInput) where it cannot be read; the old one is kept then.
    bool isLightMapOfLook(const std::filesystem::path& file) const { return lightMaps_.uses(file); }
    void reloadLightMap(const std::filesystem::path& file) {
        lightMaps_.reload(file, loaded_.scene);
    }

    /// Pictures of the scene that come after it; the look is to be brought again then.
    void takePictures(std::vector<std::pair<std::size_t, Image>> pictures);

    /// Draws, or keeps the picture where nothing changed.
    const FramePlan& draw(const Camera& camera, const FrameSettings& settings);
    const Renderer& renderer() const { return *renderer_; }
    /// For measurements that draw frames of their own; none is there to look at afterwards.
    Renderer& lendRenderer() {
        hasPicture_ = false;
        return *renderer_;
    }
    /// Times of the passes of the last frame; waits for them.
    std::vector<PassTime> takeTimes() { return renderer_->takeTimes(); }
    /// Makes all programs anew, from the shaders as they are now, and draws the frame with them.
    /// Throws Error(kBadInput) where one of them is wrong; the old ones are kept then.
    void renewPrograms(const Camera& camera, const FrameSettings& settings);

    /// Whether there is a frame to look at yet.
    bool hasPicture() const { return hasPicture_; }
    /// The pixel of the last frame (from the lower left) at a share of the window's width and
    /// height (from the upper left), 0..1; kept within the frame. Needs a frame.
    glm::ivec2 pixelAt(glm::dvec2 share) const;
    /// The point of a surface that is seen at a pixel of the last frame (from the lower left), in
    /// world metres; none where nothing is hit, and without a frame. Waits for the GPU.
    std::optional<glm::dvec3> surfaceAt(glm::ivec2 pixel) const;
    /// Light of that pixel in cd/m2, by channel. Needs a frame.
    glm::dvec3 lightAt(glm::ivec2 pixel) const;

  private:
    std::filesystem::path path_;
    LoadedScene loaded_;
    Scene asLoaded_;  ///< its lamps alone
    std::vector<LampId> lamps_;
    Bounds bounds_;
    LookLightMaps lightMaps_;
    const FileCache* cache_;
    std::unique_ptr<Renderer> renderer_;
    bool hasPicture_ = false;
};

}  // namespace ribalta
