// The layers of a frame that is read back: which way they run and what their numbers mean.
#include <cmath>

#include "gpu_test.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

class FrameLayersTest : public GpuTest {
  protected:
    FrameLayersTest() {
        layers_.beams = layers_.transmittance = layers_.depth = layers_.normal = true;
        settings_.haze.scatteringPerMetre = 0.05;
        settings_.haze.absorptionPerMetre = 0.02;
    }
    static std::vector<Camera> lenses(const glm::dvec3& position, const glm::dvec3& target) {
        Camera endless = makeCamera(position, target);
        Camera ending = endless;
        ending.farMetres = 100.0;
        Camera flat = ending;
        flat.lens = OrthographicLens{2.0, 1.5};
        return {endless, ending, flat};
    }

    FrameLayers layers_;
    FrameSettings settings_ = measuringSettings();
};

TEST_F(FrameLayersTest, ChannelsHaveTheirNames) {
    const Frame3 frame = drawOnce({}, makeCamera({0, 0, 0}, {0, 0, -1}), settings_, layers_);
    const std::vector<std::string> names = {"R",
                                            "G",
                                            "B",
                                            "beams.R",
                                            "beams.G",
                                            "beams.B",
                                            "transmittance.R",
                                            "transmittance.G",
                                            "transmittance.B",
                                            "normal.X",
                                            "normal.Y",
                                            "normal.Z",
                                            "Z"};
    EXPECT_EQ(frame.image.channels, names);
    EXPECT_EQ(frame.image.values.size(), 64U * 48U * names.size());
    EXPECT_EQ(drawOnce({}, makeCamera({0, 0, 0}, {0, 0, -1}), settings_).image.channels,
              (std::vector<std::string>{"R", "G", "B"}));
}

TEST_F(FrameLayersTest, DepthNormalAndTransmittanceOfATiltedWall) {
    Scene scene;
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, 0.4, 1.0));
    const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), normal));
    const glm::dvec3 v = glm::cross(normal, u);
    addShape(scene, makeQuad({0, 0, 0}, glm::vec3(0.8 * u), glm::vec3(0.8 * v)),
             makeMaterial(glm::vec3(0.5F)));
    for (const Camera& camera : lenses({0.5, 0.2, 3.0}, {0, 0, 0})) {
        const Frame3 frame = drawOnce(scene, camera, settings_, layers_);
        int wall = 0;
        int open = 0;
        for (int y = 0; y < settings_.height; ++y) {
            for (int x = 0; x < settings_.width; ++x) {
                const PixelRay ray = pixelRay(camera, settings_.width, settings_.height, x, y);
                const double t = -glm::dot(ray.origin, normal) / glm::dot(ray.direction, normal);
                const glm::dvec3 point = ray.origin + t * ray.direction;
                const double out =
                    std::max(std::abs(glm::dot(point, u)), std::abs(glm::dot(point, v)));
                if (out < 0.799) {
                    ++wall;
                    const double depth = t / ray.metresPerDepth;
                    ASSERT_NEAR(frame.depth(x, y), depth, 1e-4 * depth);
                    // Normals are half floats.
                    ASSERT_LT(glm::length(frame.color(x, y, "normal") - normal), 2e-3);
                    const double left = std::exp(-0.07 * t);
                    ASSERT_NEAR(frame.color(x, y, "transmittance").y, left, 1e-4 * left);
                } else if (out > 0.801) {
                    ++open;
                    ASSERT_TRUE(std::isinf(frame.depth(x, y)));
                    ASSERT_EQ(frame.color(x, y, "normal"), glm::dvec3(0.0));
                    ASSERT_EQ(frame.color(x, y, "transmittance"), glm::dvec3(0.0));
                }
            }
        }
        EXPECT_GT(wall, 100);
        EXPECT_GT(open, 100);
    }
}

TEST_F(FrameLayersTest, NormalsOfABallAreUnitAndPointOutwards) {
    Scene scene;
    addShape(scene, makeSphere({0, 0, 0}, 1.0F, 128), makeMaterial(glm::vec3(0.5F)));
    // A node turned and stretched: normals follow the inverse transpose.
    scene.nodes[0].worldFromLocal[1][1] = 2.0;
    const Camera camera = makeCamera({3, 2, 4}, {0, 0, 0});
    const Frame3 frame = drawOnce(scene, camera, settings_, layers_);
    int ball = 0;
    for (int y = 0; y < settings_.height; ++y) {
        for (int x = 0; x < settings_.width; ++x) {
            if (std::isinf(frame.depth(x, y))) {
                continue;
            }
            ++ball;
            const PixelRay ray = pixelRay(camera, settings_.width, settings_.height, x, y);
            const glm::dvec3 point =
                ray.origin + frame.depth(x, y) * ray.metresPerDepth * ray.direction;
            const glm::dvec3 expected = glm::normalize(glm::dvec3(point.x, point.y / 4.0, point.z));
            const glm::dvec3 normal = frame.color(x, y, "normal");
            EXPECT_NEAR(glm::length(normal), 1.0, 2e-3);
            EXPECT_GT(glm::dot(normal, expected), 0.999) << x << ", " << y;
        }
    }
    EXPECT_GT(ball, 300);
}

TEST_F(FrameLayersTest, InClearAirAllLightIsLeft) {
    settings_.haze = {};
    settings_.haze.scatteringPerMetre = 0.0;
    const Frame3 frame = drawOnce({}, makeCamera({0, 0, 0}, {0, 0, -1}), settings_, layers_);
    EXPECT_EQ(frame.color(5, 5, "transmittance"), glm::dvec3(1.0));
    EXPECT_EQ(frame.color(5, 5, "beams"), glm::dvec3(0.0));
}

TEST_F(FrameLayersTest, BeamsAndAttenuatedSurfacesAreTheWhole) {
    Scene scene;
    scene.spotLights.push_back(makeSpot({1, 4, 1}, {0, 0, 0}, 0.4, 2000.0));
    addShape(scene, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}), makeMaterial({0.8F, 0.5F, 0.2F}));
    addShape(scene, makeSphere({0, 0.5, 0}, 0.5F), makeMaterial({0.2F, 0.5F, 0.8F}));
    for (const Camera& camera : lenses({0.5, 2.0, 5.0}, {0, 0.8, 0})) {
        for (const auto method : {BeamMethod::kClipped, BeamMethod::kPlanes}) {
            settings_.beams.method = method;
            const Frame3 whole = drawOnce(scene, camera, settings_, layers_);
            // Haze that takes as much and scatters nothing.
            FrameSettings absorbing = settings_;
            absorbing.haze.absorptionPerMetre = settings_.haze.extinctionPerMetre();
            absorbing.haze.scatteringPerMetre = 0.0;
            const Frame3 surfaces = drawOnce(scene, camera, absorbing, {});
            bool anyBeam = false;
            for (int y = 0; y < settings_.height; ++y) {
                for (int x = 0; x < settings_.width; ++x) {
                    const glm::dvec3 beams = whole.color(x, y, "beams");
                    const glm::dvec3 sum = beams + surfaces.color(x, y);
                    ASSERT_LT(glm::length(whole.color(x, y) - sum),
                              1e-5 * (glm::length(sum) + 0.01));
                    anyBeam = anyBeam || beams.x > 0.0;
                }
            }
            EXPECT_TRUE(anyBeam);
        }
    }
}

TEST_F(FrameLayersTest, RowsRunFromTheTop) {
    Scene scene;
    Material glowing = makeMaterial(glm::vec3(0.0F));
    glowing.emission = {100.0F, 50.0F, 25.0F};
    addShape(scene, makeQuad({-1, 1, 0}, {0.4F, 0, 0}, {0, 0.4F, 0}), glowing);
    settings_ = measuringSettings(40, 40);
    const Frame3 frame = drawOnce(scene, makeCamera({0, 0, 5}, {0, 0, 0}), settings_, layers_);
    double sum[2][2] = {};
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) {
            sum[y / 20][x / 20] += frame.color(x, y).x;
        }
    }
    EXPECT_GT(sum[0][0], 0.0);
    EXPECT_EQ(sum[0][1] + sum[1][0] + sum[1][1], 0.0);
}

}  // namespace
}  // namespace ribalta::test
