// Shadows of spots: where they fall on surfaces and in the haze, and that neither lit surfaces
// shade themselves nor light leaks through walls.
#include <cmath>
#include <functional>

#include "base/angles.h"
#include "gpu_test.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

// The map of a picture this small, in texels a side.
constexpr int kMapSide = 256;

/// A texel's width on a surface square to the axis, `depth` metres from the lamp.
double texelMetres(const SpotLight& lamp, double depth) {
    return 2.0 * depth * std::tan(lamp.outerConeAngle) / (kMapSide - 4);
}

class Shadow : public GpuTest {
  protected:
    int add(Primitive primitive) {
        return addShape(scene_, std::move(primitive), makeMaterial(glm::vec3(0.7F)));
    }
    void addFloor(float half = 6.0F) { add(makeQuad({0, 0, 0}, {half, 0, 0}, {0, 0, -half})); }

    /// The frame as it is and as it would be if nothing cast a shadow: blended surfaces cast none
    /// and, fully opaque, look the same otherwise.
    struct Both {
        Frame3 shadowed;
        Frame3 open;
    };
    Both drawBoth(const FrameLayers& layers = {}) {
        settings_.beamsOutput = layers.beams;
        Renderer renderer(scene_);
        const FramePlan& plan = renderer.draw(camera_, settings_);
        EXPECT_EQ(plan.shadowMaps.side, kMapSide);
        Both both;
        both.shadowed = readBack(renderer, layers);
        Scene open = scene_;
        for (Material& material : open.materials) {
            material.alphaMode = Material::AlphaMode::kBlend;
        }
        both.open = drawOnce(open, camera_, settings_, layers);
        return both;
    }

    /// Calls `check` with every floor point in view and how much of its light is left there; points
    /// with less than a tenth of the brightest light are left out.
    void forFloor(const std::function<void(const glm::dvec3& point, double share)>& check) {
        const Both both = drawBoth();
        double brightest = 0.0;
        for (int y = 0; y < settings_.height; ++y) {
            for (int x = 0; x < settings_.width; ++x) {
                brightest = std::max(brightest, both.open.color(x, y).x);
            }
        }
        int points = 0;
        for (int y = 0; y < settings_.height; ++y) {
            for (int x = 0; x < settings_.width; ++x) {
                const PixelRay ray = pixelRay(camera_, settings_.width, settings_.height, x, y);
                const double t = -ray.origin.y / ray.direction.y;
                const double light = both.open.color(x, y).x;
                if (t > 0.0 && light > 0.1 * brightest) {
                    ++points;
                    check(ray.origin + t * ray.direction, both.shadowed.color(x, y).x / light);
                }
            }
        }
        EXPECT_GT(points, 200);
    }

    Scene scene_;
    Camera camera_ = makeCamera({0, 6, 0}, {0, 0, 0}, 0.7);
    FrameSettings settings_ = measuringSettings(128, 96);
};

TEST_F(Shadow, ABallsShadowOnTheFloorIsWhereItBelongs) {
    const SpotLight lamp = makeSpot({0, 5, 0}, {0, 0, 0}, 16.0 * kDegree, 1000.0);
    scene_.spotLights = {lamp};
    addFloor();
    add(makeSphere({0, 2, 0}, 0.4F, 256));
    // The camera looks along the floor, past the ball.
    camera_ = makeCamera({1.6, 1.2, 2.2}, {0.3, 0, 0}, 0.9);
    const double radius = 5.0 * std::tan(std::asin(0.4 / 3.0));
    const double edge = 2.0 * texelMetres(lamp, 5.0);
    int dark = 0;
    int lit = 0;
    forFloor([&](const glm::dvec3& point, double share) {
        const double from = std::hypot(point.x, point.z);
        // Where the ball hides the floor another surface is seen.
        const glm::dvec3 way = point - camera_.frame.position;
        const glm::dvec3 ball = glm::dvec3(0, 2, 0) - camera_.frame.position;
        if (glm::length(glm::cross(way, ball)) < 0.42 * glm::length(way)) {
            return;
        }
        if (from < radius - edge) {
            EXPECT_LT(share, 0.01) << from;
            ++dark;
        } else if (from > radius + edge) {
            EXPECT_GT(share, 0.99) << from;
            ++lit;
        }
    });
    EXPECT_GT(dark, 100);
    EXPECT_GT(lit, 200);
}

TEST_F(Shadow, ABallsShadowVolumeInTheHaze) {
    scene_.spotLights = {makeSpot({0, 5, 0}, {0, 0, 0}, 16.0 * kDegree, 1000.0)};
    add(makeSphere({0, 3.5, 0}, 0.3F, 128));
    settings_ = measuringSettings(33, 33);
    settings_.haze.scatteringPerMetre = 0.05;
    settings_.beams.planes = 64;
    FrameLayers layers;
    layers.beams = true;
    // All rays run inside the shadow, whose half angle is 11.5 degrees.
    camera_ = makeCamera({0, 2.9, 0}, {0, 0, 0}, 16.0 * kDegree);
    const Both inside = drawBoth(layers);
    // From the side and below the ball: dark in the middle of the beam, lit on both sides of it.
    camera_ = makeCamera({0, 2.0, 6.0}, {0, 2.0, 0}, 20.0 * kDegree);
    const Both side = drawBoth(layers);
    for (int y = 0; y < 33; ++y) {
        for (int x = 0; x < 33; ++x) {
            const double open = inside.open.color(x, y, "beams").x;
            ASSERT_GT(open, 0.0);
            EXPECT_LT(inside.shadowed.color(x, y, "beams").x, 0.01 * open) << x << ", " << y;
        }
    }
    // At height 2 the shadow is 0.61 m wide to each side and the beam 0.86 m; the picture 1.06 m.
    const auto share = [&](double metres) {
        const int x = int(std::lround(16.0 + metres / 1.058 * 16.5));
        return side.shadowed.color(x, 16, "beams").x / side.open.color(x, 16, "beams").x;
    };
    EXPECT_GT(share(-0.74), 0.97);
    EXPECT_GT(share(0.74), 0.97);
    // Through the middle: sqrt(0.86^2 - 0.61^2) is no way around; 29 % of the way is before and
    // behind the shadow, and lit where the cone has all but faded.
    EXPECT_LT(share(0.0), 0.5);
    EXPECT_GT(share(0.0), 0.001);
}

TEST_F(Shadow, ALitFloorDoesNotShadeItself) {
    addFloor();
    for (const double height : {0.35, 1.0, 3.0, 5.0}) {
        scene_.spotLights = {makeSpot({-5, height, 0.3}, {0, 0, 0}, 12.0 * kDegree, 1000.0)};
        SCOPED_TRACE("lamp at a height of " + std::to_string(height));
        forFloor([&](const glm::dvec3& point, double share) {
            EXPECT_NEAR(share, 1.0, 0.01) << point.x << ", " << point.z;
        });
    }
}

TEST_F(Shadow, ALitBallDoesNotShadeItself) {
    add(makeSphere({0, 1, 0}, 1.0F, 96));
    scene_.spotLights = {makeSpot({3, 4, 3}, {0, 1, 0}, 16.0 * kDegree, 1000.0)};
    camera_ = makeCamera({1.0, 2.5, 4.0}, {0, 1, 0}, 0.6);
    const Both both = drawBoth();
    int lit = 0;
    for (int y = 0; y < settings_.height; ++y) {
        for (int x = 0; x < settings_.width; ++x) {
            const PixelRay ray = pixelRay(camera_, settings_.width, settings_.height, x, y);
            const glm::dvec3 to = glm::dvec3(0, 1, 0) - ray.origin;
            const double along = glm::dot(to, ray.direction);
            const double inside = 1.0 - glm::dot(to, to) + along * along;
            if (inside < 0.01) {
                continue;
            }
            const glm::dvec3 normal =
                ray.origin + (along - std::sqrt(inside)) * ray.direction - glm::dvec3(0, 1, 0);
            const glm::dvec3 towards =
                glm::normalize(glm::dvec3(3, 4, 3) - glm::dvec3(0, 1, 0) - normal);
            const double open = both.open.color(x, y).x;
            // Up to 84 degrees from the lamp.
            if (glm::dot(normal, towards) > 0.1 && open > 0.0) {
                ++lit;
                EXPECT_GT(both.shadowed.color(x, y).x, 0.99 * open) << x << ", " << y;
            }
        }
    }
    EXPECT_GT(lit, 500);
}

TEST_F(Shadow, NoLightLeaksThroughAThinWallAndItsShadowBeginsAtItsFoot) {
    // A wall of a centimetre between the lamp and half of the floor.
    addFloor();
    add(makeBox({0.0F, 0.0F, -3.0F}, {0.01F, 1.5F, 3.0F}));
    const SpotLight lamp = makeSpot({-3, 3, 0}, {0.3, 0, 0}, 18.0 * kDegree, 1000.0);
    scene_.spotLights = {lamp};
    camera_ = makeCamera({0.6, 2.2, 0}, {0.6, 0, 0.01}, 0.9);
    const double texel = texelMetres(lamp, 4.3);
    int dark = 0;
    forFloor([&](const glm::dvec3& point, double share) {
        // The filter and the way the bias moves a point take a few texels at the foot.
        if (point.x > 0.01 + 5.0 * texel && point.x < 2.5) {
            EXPECT_LT(share, 0.01) << point.x << ", " << point.z;
            ++dark;
        }
    });
    EXPECT_GT(dark, 300);
}

TEST_F(Shadow, TheFarSideOfAThinWallIsDark) {
    add(makeBox({0.0F, 0.0F, -3.0F}, {0.01F, 1.5F, 3.0F}));
    scene_.spotLights = {makeSpot({-3, 2, 0}, {0, 0.7, 0}, 18.0 * kDegree, 1000.0)};
    camera_ = makeCamera({3, 0.7, 0.5}, {0, 0.7, 0}, 0.5);
    const Frame3 frame = drawOnce(scene_, camera_, settings_);
    for (int y = 0; y < settings_.height; ++y) {
        for (int x = 0; x < settings_.width; ++x) {
            ASSERT_EQ(frame.color(x, y).x, 0.0) << x << ", " << y;
        }
    }
}

TEST_F(Shadow, AMaskedCasterCastsAMaskedShadow) {
    addFloor();
    // Its left half (x < 0) is a hole.
    scene_.images.push_back(
        makeImage(64, 64, [](int x, int) { return glm::vec4(1, 1, 1, x < 32 ? 0.0F : 1.0F); }));
    Texture texture;
    texture.image = 0;
    texture.sampler.wrapS = Sampler::Wrap::kClampToEdge;
    scene_.textures.push_back(texture);
    Material material = makeMaterial(glm::vec3(0.5F));
    material.baseColorTexture = TextureSlot{};
    material.baseColorTexture->texture = 0;
    material.alphaMode = Material::AlphaMode::kMask;
    material.doubleSided = true;
    addShape(scene_, makeQuad({0, 2.5F, 0}, {0.5F, 0, 0}, {0, 0, -0.5F}), material);
    scene_.spotLights = {makeSpot({0, 5, 0}, {0, 0, 0}, 16.0 * kDegree, 1000.0)};
    camera_ = makeCamera({0, 1.5, 2.5}, {0, 0, 0}, 0.9);
    int dark = 0;
    int lit = 0;
    forFloor([&](const glm::dvec3& point, double share) {
        // The sheet's shadow is 1 m to each side; it does not hide the floor from here.
        if (std::abs(point.z) < 0.9 && point.z > -0.9) {
            if (point.x > 0.1 && point.x < 0.9) {
                EXPECT_LT(share, 0.01) << point.x << ", " << point.z;
                ++dark;
            } else if (point.x < -0.1) {
                EXPECT_GT(share, 0.99) << point.x << ", " << point.z;
                ++lit;
            }
        }
    });
    EXPECT_GT(dark, 100);
    EXPECT_GT(lit, 100);
}

TEST_F(Shadow, ABlendedSheetCastsNone) {
    addFloor();
    Material glass = makeMaterial(glm::vec3(0.5F));
    glass.alphaMode = Material::AlphaMode::kBlend;
    addShape(scene_, makeQuad({0, 2.5F, 0}, {0.5F, 0, 0}, {0, 0, -0.5F}), glass);
    scene_.spotLights = {makeSpot({0, 5, 0}, {0, 0, 0}, 16.0 * kDegree, 1000.0)};
    camera_ = makeCamera({0, 1.5, 2.5}, {0, 0, 0}, 0.9);
    forFloor([&](const glm::dvec3&, double share) { EXPECT_NEAR(share, 1.0, 0.01); });
}

TEST_F(Shadow, EveryLampHasItsOwn) {
    addFloor();
    add(makeBox({-0.2F, 1.0F, -0.2F}, {0.2F, 1.4F, 0.2F}));
    camera_ = makeCamera({0, 0.9, 2.5}, {0, 0, 0}, 1.2);
    std::vector<Frame3> alone;
    const SpotLight lamps[] = {makeSpot({-3, 4, 0}, {0, 0, 0}, 0.4, 700.0),
                               makeSpot({3, 4, 0.5}, {0, 0, 0}, 0.4, 900.0),
                               makeSpot({0.5, 5, -3}, {0, 0, 0}, 0.4, 800.0)};
    for (const SpotLight& lamp : lamps) {
        scene_.spotLights = {lamp};
        alone.push_back(drawOnce(scene_, camera_, settings_));
    }
    scene_.spotLights.assign(std::begin(lamps), std::end(lamps));
    const Frame3 together = drawOnce(scene_, camera_, settings_);
    for (std::size_t i = 0; i < together.image.values.size(); ++i) {
        float sum = 0.0F;
        for (const Frame3& frame : alone) {
            sum += frame.image.values[i];
        }
        ASSERT_NEAR(together.image.values[i], sum, 1e-4F * (sum + 1.0F)) << i;
    }
}

}  // namespace
}  // namespace ribalta::test
