#include "viewer/stage_view.h"

#include <array>
#include <utility>

#include <epoxy/gl.h>

#include "scene/animation.h"

namespace ribalta {
namespace {

Scene lampsAlone(const Scene& scene) {
    Scene lamps;
    lamps.spotLights = scene.spotLights;
    lamps.pointLights = scene.pointLights;
    lamps.directionalLights = scene.directionalLights;
    return lamps;
}

}  // namespace

StageView::StageView(LoadedScene loaded, std::filesystem::path path, const FileCache* cache)
    : path_(std::move(path)),
      loaded_(std::move(loaded)),
      asLoaded_(lampsAlone(loaded_.scene)),
      lamps_(lampsOf(loaded_.scene)),
      bounds_(tightSceneBounds(loaded_.scene)),
      cache_(cache),
      renderer_(std::make_unique<Renderer>(loaded_.scene, cache)) {}

std::vector<std::filesystem::path> StageView::files() const {
    std::vector<std::filesystem::path> files = loaded_.files;
    for (std::filesystem::path& file : lightMaps_.files()) {
        files.push_back(std::move(file));
    }
    return files;
}

double StageView::durationSeconds(const Look& look) const {
    return ribalta::durationSeconds(scene(), animationOf(look.time, scene()));
}

Camera StageView::homeCamera(double aspectRatio) const {
    return scene().cameras.empty() ? makeFramingCamera(bounds_, aspectRatio)
                                   : posed(scene().cameras.front());
}

void StageView::bring(const Look& look) {
    Scene& scene = loaded_.scene;
    scene.spotLights = asLoaded_.spotLights;
    scene.pointLights = asLoaded_.pointLights;
    scene.directionalLights = asLoaded_.directionalLights;
    // Pictures that are still being read are not there to be projected.
    for (SpotLight& spot : scene.spotLights) {
        if (spot.lightMap && scene.images[std::size_t(spot.lightMap->image)].pixels.empty()) {
            spot.lightMap.reset();
        }
    }
    poseAt(look.time, scene);
    applyLamps(look.lamps, lightMaps_, scene);
}

void StageView::takePictures(std::vector<std::pair<std::size_t, Image>> pictures) {
    for (auto& [index, image] : pictures) {
        loaded_.scene.images[index] = std::move(image);
    }
    renderer_->usePictures();
}

void StageView::renewPrograms(const Camera& camera, const FrameSettings& settings) {
    auto renewed = std::make_unique<Renderer>(loaded_.scene, cache_);
    renewed->draw(camera, settings);
    renderer_ = std::move(renewed);
    hasPicture_ = true;
}

const FramePlan& StageView::draw(const Camera& camera, const FrameSettings& settings) {
    hasPicture_ = false;  // where drawing throws
    const FramePlan& plan = renderer_->draw(camera, settings);
    hasPicture_ = true;
    return plan;
}

glm::ivec2 StageView::pixelAt(glm::dvec2 share) const {
    const FrameSettings& drawn = renderer_->lastPlan().settings;
    const glm::ivec2 size(drawn.width, drawn.height);
    const glm::ivec2 pixel =
        glm::clamp(glm::ivec2(glm::floor(share * glm::dvec2(size))), glm::ivec2(0), size - 1);
    return {pixel.x, size.y - 1 - pixel.y};
}

std::optional<glm::dvec3> StageView::surfaceAt(glm::ivec2 pixel) const {
    if (!hasPicture_) {
        return std::nullopt;
    }
    const FrameSettings& settings = renderer_->lastPlan().settings;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, renderer_->targets().surfaces.name());
    float depth = 0.0F;
    glReadPixels(pixel.x, pixel.y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    if (!(depth > 0.0F)) {
        return std::nullopt;
    }
    const glm::dvec2 size(settings.width, settings.height);
    const glm::dvec2 at = (glm::dvec2(pixel) + 0.5) / size * 2.0 - 1.0;
    const glm::dmat4 worldFromClip =
        glm::inverse(clipFromWorld(renderer_->lastPlan().camera, settings.width, settings.height));
    const glm::dvec4 point = worldFromClip * glm::dvec4(at, double(depth), 1.0);
    return glm::dvec3(point) / point.w;
}

glm::dvec3 StageView::lightAt(glm::ivec2 pixel) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, renderer_->targets().haze.name());
    std::array<float, 3> color{};
    glReadPixels(pixel.x, pixel.y, 1, 1, GL_RGB, GL_FLOAT, color.data());
    return {color[0], color[1], color[2]};
}

}  // namespace ribalta
