// Pictures by the sky's models of the literature: what is seen is what the models say of the same
// rays, faults included; what is lit, made and kept.
#include <cmath>
#include <numbers>
#include <optional>

#include "base/angles.h"
#include "gl/counters.h"
#include "gpu_test.h"
#include "render/evaluate_baseline_sky.h"
#include "render/passes/sky_precomputed.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

PrecomputedSkySettings smallTables(bool simplified) {
    PrecomputedSkySettings settings = simplified ? simplifiedSky() : PrecomputedSkySettings{};
    settings.orders = simplified ? 1 : 2;
    settings.scattering = {8, 16, 16, 4};
    settings.irradiance = {16, 4};
    return settings;
}

std::vector<DrawnSky> models() {
    return {smallTables(false), smallTables(true), ChapmanSky{false, 16}, ChapmanSky{true, 16}};
}

/// One model's answers; its tables are made once.
class AskedModel {
  public:
    explicit AskedModel(const DrawnSky& model) : model_(model) {
        if (const auto* settings = std::get_if<PrecomputedSkySettings>(&model)) {
            tables_.emplace(Atmosphere(), *settings);
        }
    }
    std::vector<SkyLight> operator()(const std::vector<SkyRay>& rays) const {
        return tables_ ? evaluatePrecomputedSky(*tables_, rays)
                       : evaluateChapmanSky(Atmosphere(), std::get<ChapmanSky>(model_), rays);
    }

  private:
    DrawnSky model_;
    std::optional<PrecomputedSky> tables_;
};

class SkyBaselinePicture : public GpuTest {
  protected:
    SkyBaselinePicture() {
        settings_ = measuringSettings();
        settings_.sky.emplace();
    }

    void lookAt(double elevation, const glm::dvec3& from, const glm::dvec3& target) {
        camera_ = makeCamera(from, target, 1.2);
        settings_.sky->towardsSun = {std::cos(elevation * kDegree), std::sin(elevation * kDegree),
                                     0.0};
    }

    /// Every few pixels against the same rays asked for one by one; the sun's disc aside.
    void expectSamePixels(Renderer& renderer, const AskedModel& ask, double relative,
                          double ofBrightest) {
        renderer.draw(camera_, settings_);
        const Frame3 frame = readBack(renderer, {.depth = true});
        EXPECT_EQ(countNotFinite(frame), 0);
        const SkyEye eye = skyEye(*settings_.sky, camera_.frame.position);
        std::vector<SkyRay> rays;
        std::vector<glm::dvec3> seen;
        for (int y = 1; y < settings_.height; y += 3) {
            for (int x = 1; x < settings_.width; x += 5) {
                const PixelRay pixel = pixelRay(camera_, settings_.width, settings_.height, x, y);
                SkyRay ray{eye.heightMetres, glm::dot(pixel.direction, eye.zenith), eye.muS,
                           glm::dot(pixel.direction, settings_.sky->towardsSun)};
                const double depth = frame.depth(x, y);
                if (std::isfinite(depth)) {
                    ray.distanceMetres = depth * pixel.metresPerDepth;
                }
                if (ray.nu < std::cos(2.0 * kDegree)) {
                    rays.push_back(ray);
                    seen.push_back(frame.color(x, y) / settings_.sky->air.sunIlluminanceLux);
                }
            }
        }
        const std::vector<SkyLight> lights = ask(rays);
        double brightest = 0.0;
        for (const SkyLight& light : lights) {
            brightest = std::max(brightest, light.air.y + light.ground.y);
        }
        EXPECT_GT(brightest, 0.0);
        int off = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            // A black surface hides the ground, even where it lies below it.
            const bool hidden = std::isfinite(rays[i].distanceMetres);
            const glm::dvec3 right = lights[i].air + (hidden ? glm::dvec3(0.0) : lights[i].ground);
            for (int c = 0; c < 3; ++c) {
                const double bound = relative * std::abs(right[c]) + ofBrightest * brightest;
                off += std::abs(seen[i][c] - right[c]) > bound ? 1 : 0;
            }
        }
        // On the horizon a pixel's ray may fall to either side.
        EXPECT_LE(off, int(rays.size() / 50)) << "of " << rays.size() << " rays";
    }

    Scene scene_;
    Camera camera_;
    FrameSettings settings_;
};

TEST_F(SkyBaselinePicture, SkyAndGroundAreTheModelsOwn) {
    struct View {
        double sun;
        glm::dvec3 from;
        glm::dvec3 target;
    };
    const View views[] = {{40.0, {0, 2, 0}, {1, 2.2, 0.4}},            // on the ground
                          {1.0, {0, 2e3, 0}, {1, 2e3 - 0.1, 0.4}},     // at sunset, on a mountain
                          {30.0, {0, 59e3, 0}, {1, 59e3 - 0.3, 0.4}},  // entering the air
                          {20.0, {0, 400e3, 0}, {1, 400e3 - 0.4, 0.4}},
                          {-5.0, {0, 9e6, 0}, {1, 9e6 - 2.0, 0.4}}};  // the limb from the night
    Renderer renderer(scene_);
    for (const DrawnSky& model : models()) {
        settings_.sky->model = model;
        const AskedModel ask(model);
        for (const View& view : views) {
            SCOPED_TRACE("model " + std::to_string(model.index()) + " at " +
                         std::to_string(view.from.y) + " m");
            lookAt(view.sun, view.from, view.target);
            expectSamePixels(renderer, ask, 2e-3, 2e-4);
        }
    }
}

TEST_F(SkyBaselinePicture, AirBeforeSurfacesIsTheModelsOwn) {
    for (const double metres : {200.0, 20e3}) {
        scene_ = {};
        // Black, so that only the air before it is seen.
        const auto side = float(2.0 * metres);
        addShape(scene_, makeQuad({float(metres), 30.0F, 0}, {0, 0, side}, {0, 0.5F * side, 0}),
                 makeMaterial(glm::vec3(0.0F)));
        scene_.materials.back().unlit = true;
        Renderer renderer(scene_);
        for (const DrawnSky& model : models()) {
            SCOPED_TRACE("model " + std::to_string(model.index()) + " before " +
                         std::to_string(metres) + " m");
            settings_.sky->model = model;
            lookAt(30.0, {0, 40, 0}, {1, 40.3, 0});
            // The tables' difference of two look-ups doubles what singles lose.
            expectSamePixels(renderer, AskedModel(model), 5e-3, 5e-4);
        }
    }
}

TEST_F(SkyBaselinePicture, TheModelLightsTheScene) {
    addShape(scene_, makeQuad({0, 0, 0}, {50, 0, 0}, {0, 0, -50}), makeMaterial(glm::vec3(0.5F)));
    lookAt(40.0, {0, 3, 0.1}, {0, 0, 0});
    for (const DrawnSky& model : models()) {
        SCOPED_TRACE("model " + std::to_string(model.index()));
        settings_.sky->model = model;
        // What the planet's ground reflects tells its irradiance.
        const double muS = std::sin(40.0 * kDegree);
        const SkyLight down = AskedModel(model)({{1.0, -1.0, muS, -muS}}).front();
        const Atmosphere& air = settings_.sky->air;
        const glm::dvec3 lux = air.sunIlluminanceLux * down.ground / down.transmittance *
                               std::numbers::pi / air.groundAlbedo;
        const glm::dvec3 middle = drawOnce(scene_, camera_, settings_).color(32, 24);
        for (int c = 0; c < 3; ++c) {
            // A rough surface reflects a little more than its base colour.
            EXPECT_NEAR(middle[c] / (0.5 / std::numbers::pi * lux[c]), 1.05, 0.08) << c;
        }
    }
}

TEST_F(SkyBaselinePicture, ScenesInSpaceAreLitToo) {
    addShape(scene_, makeQuad({0, 0, 0}, {50, 0, 0}, {0, 0, -50}), makeMaterial(glm::vec3(0.5F)));
    Renderer renderer(scene_);
    for (const DrawnSky& model : models()) {
        settings_.sky->model = model;
        settings_.sky->altitudeMetres = 400e3;
        lookAt(40.0, {0, 3, 0.1}, {0, 0, 0});
        renderer.draw(camera_, settings_);
        const double open = readBack(renderer).color(32, 24).z;
        EXPECT_NEAR(open / (0.5 / std::numbers::pi * 128e3 * std::sin(40.0 * kDegree)), 1.05, 0.08);
        // 400 km up the horizon lies 19.9 degrees lower; at -30 the planet is before the sun.
        lookAt(-30.0, {0, 3, 0.1}, {0, 0, 0});
        renderer.draw(camera_, settings_);
        EXPECT_EQ(readBack(renderer).color(32, 24).z, 0.0);
    }
}

TEST_F(SkyBaselinePicture, TheSunsDiscIsDimmedByTheModel) {
    settings_ = measuringSettings(96, 96);
    settings_.sky.emplace();
    for (const DrawnSky& model : models()) {
        SCOPED_TRACE("model " + std::to_string(model.index()));
        settings_.sky->model = model;
        lookAt(30.0, {0, 2, 0}, {1, 2, 0});
        camera_ = makeCamera({0, 2, 0}, camera_.frame.position + settings_.sky->towardsSun, 0.02);
        const Frame3 frame = drawOnce(scene_, camera_, settings_);
        const double pixel = 2.0 * std::tan(0.01) / 96.0;
        glm::dvec3 sum(0.0);
        for (int y = 0; y < 96; ++y) {
            for (int x = 0; x < 96; ++x) {
                sum += frame.color(x, y) * pixel * pixel;
            }
        }
        const SkyLight towards = AskedModel(model)({{2.0, 0.5, 0.5, 1.0}}).front();
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(sum[c] / (128e3 * towards.transmittance[c]), 1.0, 0.03) << c;
        }
    }
}

TEST_F(SkyBaselinePicture, TablesAreMadeOnceAndGivenBack) {
    addShape(scene_, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}), makeMaterial(glm::vec3(0.5F)));
    lookAt(30.0, {0, 2, 8}, {0, 1, 0});
    const std::uint64_t start = glCounters().bytesAllocated;
    {
        Renderer renderer(scene_);
        settings_.sky->model = ChapmanSky{};
        const std::uint64_t texturesBefore = glCounters().texturesMade;
        EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "sun_shadow[1] forward sky");
        const std::uint64_t none = glCounters().bytesAllocated;
        const std::uint64_t targets = glCounters().texturesMade - texturesBefore;

        settings_.sky->model = smallTables(false);
        EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "forward sky_tables sky");
        const std::uint64_t tables =
            PrecomputedSky(Atmosphere(), smallTables(false)).cost().keptBytes;
        EXPECT_NEAR(double(glCounters().bytesAllocated - none), double(tables), 1024.0);
        const std::uint64_t made = glCounters().texturesMade;
        settings_.sky->towardsSun = {0.0, 1.0, 0.0};
        EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "sun_shadow[1] forward sky");
        EXPECT_EQ(glCounters().texturesMade, made);

        settings_.sky->model = OwnSky{};
        EXPECT_EQ(renderer.draw(camera_, settings_).describe(),
                  "forward sky_tables sky_view aerial sky");
        settings_.sky->model = ChapmanSky{};
        EXPECT_EQ(renderer.draw(camera_, settings_).describe(), "forward sky");
        EXPECT_NEAR(double(glCounters().bytesAllocated), double(none), 1024.0);
        EXPECT_LT(targets, 4U) << "what every picture is drawn into";
    }
    EXPECT_EQ(glCounters().bytesAllocated, start);
}

}  // namespace
}  // namespace ribalta::test
