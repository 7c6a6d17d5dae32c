#include "reference/reference_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "base/check.h"
#include "base/parallel_for.h"
#include "optics/shader_lib.h"
#include "reference/cast_rays.h"
#include "reference/integrate_beams.h"
#include "reference/material_textures.h"
#include "reference/placed_surface.h"
#include "reference/shadow_map_visibility.h"
#include "reference/surface_light.h"
#include "reference/triangle_shadows.h"

namespace ribalta {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

/// The ray through a pixel's centre.
struct PixelRay {
    glm::dvec3 origin;
    glm::dvec3 direction;         ///< unit
    double metresPerDepth = 1.0;  ///< along the ray for one along the view axis
    double width = 0.0;           ///< of the pixel, as in BeamRay
    double widening = 0.0;
    /// To the origin and the unscaled direction of the ray one pixel to the right, and one up.
    glm::dvec3 toRight{0.0};
    glm::dvec3 toUp{0.0};
};

class PixelRays {
  public:
    PixelRays(const Camera& camera, int width, int height)
        : camera_(camera), size_(width, height), half_(viewHalfExtent(camera, width, height)) {}

    /// Rows from the top.
    PixelRay at(int x, int y) const {
        const Frame& frame = camera_.frame;
        const double across = (2.0 * x + 1.0) / size_.x - 1.0;
        const double up = 1.0 - (2.0 * y + 1.0) / size_.y;
        const glm::dvec3 aside = across * half_.x * frame.right() + up * half_.y * frame.up();
        const double pixel = 2.0 * half_.y / size_.y;
        const glm::dvec3 toRight = 2.0 * half_.x / size_.x * frame.right();
        const glm::dvec3 toUp = pixel * frame.up();
        if (camera_.isOrthographic()) {
            return {frame.position + aside, frame.forward(), 1.0, pixel, 0.0, toRight, toUp};
        }
        const glm::dvec3 unscaled = frame.forward() + aside;
        const double length = glm::length(unscaled);
        return {frame.position, unscaled / length, length, 0.0, pixel, toRight, toUp};
    }

  private:
    const Camera& camera_;
    glm::dvec2 size_;
    glm::dvec2 half_;
};

/// The scene's triangles as the eye and the lamps see them.
struct TracedScene {
    std::vector<PlacedSurface> surfaces;
    MaterialTextures textures;
    RayCaster caster;

    TracedScene(const Scene& scene, const Camera& camera)
        : surfaces(placeSurfaces(scene, camera)),
          textures(scene),
          caster(surfaces, textures, camera.frame.position) {}
};

/// One frame's work; a row at a time, from any thread.
class ReferenceFrame {
  public:
    ReferenceFrame(const Scene& scene, const ReferenceSettings& settings)
        : settings_(settings),
          rays_(settings_.camera, settings.width, settings.height),
          extinction_(settings.haze.extinctionPerMetre()) {
        if (settings.drawn == nullptr) {
            traced_ = std::make_unique<TracedScene>(scene, settings.camera);
        }
        integrator_ =
            std::make_unique<BeamIntegrator>(scene.spotLights, scene.images, settings.haze,
                                             makeVisibility(), settings.relativeError);
        if (traced_) {
            if (settings.sky) {
                sight_ = std::make_unique<SkySight>(*settings.sky, settings.skyTables);
                daylight_ = std::make_unique<SkyDaylight>(*sight_);
            }
            light_ =
                std::make_unique<SurfaceLight>(scene, integrator_->lamps(), traced_->caster,
                                               settings.haze, settings.ambientLux, daylight_.get());
        }
        const std::size_t pixels = std::size_t(settings.width) * std::size_t(settings.height);
        picture_.width = settings.width;
        picture_.height = settings.height;
        picture_.surfaces.resize(pixels);
        picture_.beams.resize(pixels);
        picture_.depths.resize(pixels);
        errors_.resize(pixels);
    }

    void drawRow(int y) {
        Sight sight;
        for (int x = 0; x < settings_.width; ++x) {
            drawPixel(x, y, sight);
        }
    }

    void drawPixel(int x, int y, Sight& sight) {
        const std::size_t pixel = pixelAt(x, y);
        const PixelRay ray = rays_.at(x, y);
        const double last = traced_ ? traceSurfaces(ray, pixel, sight) : readSurfaces(ray, pixel);
        const double first = settings_.camera.nearMetres * ray.metresPerDepth;
        if (first < last) {
            drawBeams({ray.origin, ray.direction, first, last, ray.width, ray.widening}, pixel);
        }
    }

    const glm::dvec3& beams(int x, int y) const { return picture_.beams[pixelAt(x, y)]; }

    ReferencePicture finish() {
        double squares = 0.0;
        for (const double error : errors_) {
            squares += error * error;
            picture_.largestError = std::max(picture_.largestError, error);
        }
        picture_.rmsError = std::sqrt(squares / double(errors_.size()));
        if (sight_) {
            picture_.skyError = sight_->errorOf(skyRays());
        }
        return std::move(picture_);
    }

  private:
    std::size_t pixelAt(int x, int y) const {
        return std::size_t(y) * std::size_t(settings_.width) + std::size_t(x);
    }

    std::unique_ptr<BeamVisibility> makeVisibility() const {
        if (traced_) {
            return std::make_unique<TriangleShadows>(traced_->surfaces, traced_->textures);
        }
        return std::make_unique<ShadowMapVisibility>(settings_.drawn->shadowMaps);
    }

    /// Metres along the ray to where it ends.
    double traceSurfaces(const PixelRay& ray, std::size_t pixel, Sight& sight) {
        const double first = settings_.camera.nearMetres * ray.metresPerDepth;
        const double farthest = settings_.camera.farMetres * ray.metresPerDepth;
        traced_->caster.look(ray.origin, ray.direction, first, farthest, sight);
        glm::dvec3 color(0.0);
        if (sight.opaque) {
            color = throughAir(surfaceLight(*sight.opaque, ray).light, ray, *sight.opaque);
        } else if (sight_) {
            color = sight_->behind(ray.origin, ray.direction, pixelRadians());
        }
        for (const SurfaceHit& hit : sight.blended) {
            SeenSurface over = surfaceLight(hit, ray);
            over.light = throughAir(over.light, ray, hit);
            color = color * over.kept + over.light * over.alpha;
        }
        picture_.surfaces[pixel] = color;
        picture_.depths[pixel] =
            sight.opaque ? sight.opaque->distance / ray.metresPerDepth : kNothing;
        return sight.opaque ? sight.opaque->distance : farthest;
    }

    double pixelRadians() const {
        return 2.0 * viewHalfExtent(settings_.camera, settings_.width, settings_.height).y /
               settings_.height;
    }

    glm::dvec3 throughAir(const glm::dvec3& light, const PixelRay& ray,
                          const SurfaceHit& hit) const {
        return sight_ ? sight_->throughAir(light, ray.origin, ray.direction, hit.distance) : light;
    }

    /// Those of some pixels.
    std::vector<SkyRay> skyRays() const {
        constexpr int kAcross = 8;
        std::vector<SkyRay> rays;
        for (int i = 0; i < kAcross * kAcross; ++i) {
            const int x = (2 * (i % kAcross) + 1) * settings_.width / (2 * kAcross);
            const int y = (2 * (i / kAcross) + 1) * settings_.height / (2 * kAcross);
            const PixelRay pixel = rays_.at(x, y);
            rays.push_back(sight_->ray(pixel.origin, pixel.direction));
            rays.back().distanceMetres =
                picture_.depths[std::size_t(y) * std::size_t(settings_.width) + std::size_t(x)] *
                pixel.metresPerDepth;
        }
        return rays;
    }

    struct SeenSurface {
        glm::dvec3 light;  ///< cd/m2 at the eye
        double alpha;
        glm::dvec3 kept;  ///< of what is behind
    };
    SeenSurface surfaceLight(const SurfaceHit& hit, const PixelRay& ray) const {
        ShadedPoint point = shadedPoint(traced_->surfaces[hit.surface], traced_->textures, hit,
                                        ray.origin, ray.direction);
        // Where the neighbours' rays meet the surface's plane, to first order.
        const double facing = glm::dot(point.geometric, ray.direction);
        const auto onPlane = [&](const glm::dvec3& toNeighbour) {
            const glm::dvec3 aside = settings_.camera.isOrthographic()
                                         ? toNeighbour
                                         : toNeighbour * (hit.distance / ray.metresPerDepth);
            return facing == 0.0
                       ? glm::dvec3(0.0)
                       : aside - ray.direction * (glm::dot(point.geometric, aside) / facing);
        };
        point.acrossPixel = onPlane(ray.toRight);
        point.upPixel = onPlane(ray.toUp);
        return {light_->radiance(point) * shader::transmittance(extinction_, hit.distance),
                glm::clamp(point.alpha, 0.0, 1.0), keptBehind(point)};
    }

    double readSurfaces(const PixelRay& ray, std::size_t pixel) {
        picture_.surfaces[pixel] = glm::dvec3(settings_.drawn->surfaces[pixel]);
        picture_.depths[pixel] = double(settings_.drawn->depths[pixel]);
        return std::min(picture_.depths[pixel], settings_.camera.farMetres) * ray.metresPerDepth;
    }

    void drawBeams(const BeamRay& ray, std::size_t pixel) {
        const BeamLight light = integrator_->along(ray);
        picture_.beams[pixel] = light.value;
        const double largest = std::max({light.value.x, light.value.y, light.value.z});
        errors_[pixel] = largest > 0.0 ? light.error / largest : 0.0;
    }

    ReferenceSettings settings_;
    PixelRays rays_;
    double extinction_;
    std::unique_ptr<TracedScene> traced_;
    std::unique_ptr<BeamIntegrator> integrator_;
    std::unique_ptr<SkySight> sight_;
    std::unique_ptr<SkyDaylight> daylight_;
    std::unique_ptr<SurfaceLight> light_;
    ReferencePicture picture_;
    std::vector<double> errors_;  ///< relative, by pixel
};

void checkSettings(const Scene& scene, const ReferenceSettings& settings) {
    CHECK(settings.width > 0 && settings.height > 0);
    CHECK(!settings.sky ||
          (settings.drawn == nullptr && settings.haze.extinctionPerMetre() == 0.0));
    if (settings.drawn == nullptr) {
        return;
    }
    const std::size_t pixels = std::size_t(settings.width) * std::size_t(settings.height);
    CHECK(settings.drawn->shadowMaps.size() == scene.spotLights.size());
    CHECK(settings.drawn->surfaces.size() == pixels && settings.drawn->depths.size() == pixels);
    for (const std::optional<DrawnShadowMap>& map : settings.drawn->shadowMaps) {
        CHECK(!map || map->depths.size() == std::size_t(map->side) * std::size_t(map->side));
    }
}

}  // namespace

ReferencePicture drawReference(const Scene& scene, const ReferenceSettings& settings,
                               Progress* progress) {
    checkSettings(scene, settings);
    ReferenceFrame frame(scene, settings);
    parallelFor(std::size_t(settings.height), [&](std::size_t y) {
        frame.drawRow(int(y));
        if (progress != nullptr) {
            progress->step();
        }
    });
    return frame.finish();
}

class ReferencePixels::Frame : public ReferenceFrame {
  public:
    using ReferenceFrame::ReferenceFrame;
};

ReferencePixels::ReferencePixels(const Scene& scene, const ReferenceSettings& settings) {
    checkSettings(scene, settings);
    frame_ = std::make_unique<Frame>(scene, settings);
}

ReferencePixels::~ReferencePixels() = default;

glm::dvec3 ReferencePixels::beams(int x, int y) {
    Sight sight;
    frame_->drawPixel(x, y, sight);
    return frame_->beams(x, y);
}

std::size_t countUnseenPrimitives(const Scene& scene) {
    std::size_t count = 0;
    for (const Node& node : scene.nodes) {
        if (node.isDrawn()) {
            const auto& primitives = scene.meshes[std::size_t(node.mesh)].primitives;
            count += std::size_t(
                std::count_if(primitives.begin(), primitives.end(), [](const Primitive& primitive) {
                    return primitive.topology != Topology::kTriangles && !primitive.indices.empty();
                }));
        }
    }
    return count;
}

}  // namespace ribalta
