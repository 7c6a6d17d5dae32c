#include "render/renderer.h"

#include "gl/debug_output.h"

namespace ribalta {
namespace {

// The pass, made now if this is its first work.
template <typename Pass, typename... Arguments>
Pass& madeOnFirstUse(std::optional<Pass>& pass, const Arguments&... arguments) {
    if (!pass) {
        pass.emplace(arguments...);
    }
    return *pass;
}

void clear(const FrameTargets& targets) {
    targets.surfaces.bind();
    glDepthMask(GL_TRUE);
    const float black[] = {0.0F, 0.0F, 0.0F, 0.0F};
    const float farthest = 0.0F;
    glClearBufferfv(GL_COLOR, 0, black);
    if (targets.normals) {
        glClearBufferfv(GL_COLOR, 1, black);
    }
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    if (targets.beams) {
        glClearTexImage(targets.beams.name(), 0, GL_RGBA, GL_FLOAT, black);
    }
}

}  // namespace

Renderer::Renderer(const Scene& scene, const FileCache* files)
    : scene_(scene), files_(files), gpuScene_(scene), uploadedMaterials_(materialNumbers(scene)) {}

const FramePlan& Renderer::draw(const Camera& camera, const FrameSettings& settings) {
    FrameInputs inputs = frameInputs(scene_, camera, settings);
    if (drawn_ == inputs) {
        plan_.keepPicture();
        return plan_;
    }
    drawn_.reset();
    addLitRegions(scene_, litRegions_);
    plan_ = planFrame(scene_, camera, settings, cache_, litRegions_);
    if (!targets_ || !targets_->suit(settings)) {
        targets_.reset();
        targets_.emplace(settings);
    }
    const SkyLighting* daylight = nullptr;
    if (plan_.sky) {
        timer_.begin("sky_tables");
        daylight = &madeOnFirstUse(sky_, files_).prepare(*plan_.sky);
        sky_->uploadFrame(*plan_.sky, camera);
    }
    if (!plan_.deformWork.empty()) {
        timer_.begin("deform");
        const DebugGroup group("deform");
        madeOnFirstUse(deform_).draw(plan_.deformWork, scene_, gpuScene_);
    }
    timer_.begin("upload");
    gpuScene_.useLightMaps(scene_, plan_.spotsDrawn());
    if (uploadedMaterials_ != inputs.materials) {
        gpuScene_.useMaterials(scene_);
        uploadedMaterials_ = inputs.materials;
    }
    gpuFrame_.upload(scene_, plan_, gpuScene_, daylight);

    if (!plan_.shadowMapWork.empty()) {
        timer_.begin("shadow_map");
        const DebugGroup group("shadow_map");
        madeOnFirstUse(shadowMapPass_)
            .draw(plan_.shadowMapWork, scene_, plan_, gpuScene_, drawCasters_);
    }
    if (!plan_.shadowPyramidWork.empty()) {
        timer_.begin("shadow_pyramid");
        const DebugGroup group("shadow_pyramid");
        madeOnFirstUse(shadowPyramidPass_).draw(plan_.shadowPyramidWork, shadowMaps());
    }
    if (plan_.sunShadow) {
        timer_.begin("sun_shadow");
        const DebugGroup group("sun_shadow");
        madeOnFirstUse(sunShadow_).draw(*plan_.sunShadow, scene_, plan_, gpuScene_, drawCasters_);
        sunShadow_->bind(*plan_.sunShadow, plan_);
    }
    timer_.begin("forward");
    clear(*targets_);
    if (plan_.forward) {
        const DebugGroup group("forward");
        madeOnFirstUse(forward_).draw(*plan_.forward, scene_, plan_, gpuScene_, gpuFrame_,
                                      shadowMaps(), *targets_);
    }
    if (plan_.sky && !settings.illuminance) {
        timer_.begin("sky");
        const DebugGroup group("sky");
        sky_->draw(*plan_.sky, plan_, *targets_);
    }
    if (plan_.beams) {
        timer_.begin("beams");
        const DebugGroup group("beams");
        drawBeams(*plan_.beams);
    }
    if (plan_.tonemap && plan_.tonemap->highestLux) {
        timer_.begin("false_color");
        const DebugGroup group("false_color");
        madeOnFirstUse(falseColor_).draw(*plan_.tonemap->highestLux, *targets_);
    } else if (plan_.tonemap) {
        timer_.begin("tonemap");
        const DebugGroup group("tonemap");
        madeOnFirstUse(exposure_).draw(plan_.tonemap->ev100, plan_.tonemap->curve, targets_->color);
        madeOnFirstUse(tonemap_).draw(*targets_);
    }
    timer_.end();
    keepForNextFrame(scene_, plan_, cache_);
    drawn_ = std::move(inputs);
    return plan_;
}

void Renderer::drawBeams(const BeamsWork& work) {
    if (work.settings.method == BeamMethod::kPlanes) {
        madeOnFirstUse(planeBeams_).draw(work, gpuScene_, shadowMaps(), *targets_);
    } else if (work.settings.method == BeamMethod::kAdaptive) {
        madeOnFirstUse(adaptiveBeams_).draw(work, gpuScene_, shadows(), *targets_);
    } else {
        madeOnFirstUse(clippedBeams_).draw(work, gpuScene_, shadows(), *targets_);
    }
}

const Texture2D& Renderer::shadowMaps() const {
    static const Texture2D none;
    return shadowMapPass_ ? shadowMapPass_->maps() : none;
}

ShadowTextures Renderer::shadows() const {
    return {&shadowMaps(), &shadowPyramid()};
}

const Texture2D& Renderer::shadowPyramid() const {
    static const Texture2D none;
    return shadowPyramidPass_ ? shadowPyramidPass_->pyramid() : none;
}

std::optional<gpu::RunCounts> Renderer::runCounts() const {
    if (!plan_.beams || !plan_.beams->shadowPyramid || !plan_.beams->countRuns) {
        return std::nullopt;
    }
    return plan_.beams->settings.method == BeamMethod::kAdaptive ? adaptiveBeams_->runCounts()
                                                                 : clippedBeams_->runCounts();
}

std::uint64_t Renderer::beamSamples() const {
    if (!plan_.beams || plan_.kept || plan_.beams->settings.method != BeamMethod::kAdaptive) {
        return plan_.beamSamples();
    }
    return std::uint64_t(plan_.beams->settings.planes) *
           adaptiveBeams_->sampledPixelLamps(*plan_.beams,
                                             {plan_.settings.width, plan_.settings.height});
}

std::optional<double> Renderer::ev100() const {
    return plan_.tonemap && !plan_.tonemap->highestLux ? std::optional<double>(exposure_->ev100())
                                                       : std::nullopt;
}

}  // namespace ribalta
