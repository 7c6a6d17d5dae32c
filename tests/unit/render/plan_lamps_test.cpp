// Which lamps a frame leaves out, and why; and that none of them would have been seen.
#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "reference/light_map_texture.h"
#include "render/frame_plan.h"
#include "render/lamp_reach.h"
#include "support/random_stage.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// A wall across the view and a camera before it; one lamp is put somewhere.
class Reasons : public testing::Test {
  protected:
    Reasons() {
        addShape(scene_, makeQuad({0, 0, 0}, {50, 0, 0}, {0, 50, 0}),
                 makeMaterial(glm::vec3(0.5F)));
        settings_.width = 64;
        settings_.height = 48;
    }
    FramePlan plan() const { return planFrame(scene_, camera_, settings_, {}, litRegions(scene_)); }
    SkippedLamps skippedOf(const SpotLight& lamp) {
        scene_.spotLights = {lamp};
        const FramePlan made = plan();
        EXPECT_EQ(made.skipped.total(), made.lampsSkipped);
        EXPECT_EQ(made.lamps.size() + std::size_t(made.lampsSkipped), 1U);
        return made.skipped;
    }

    Scene scene_;
    Camera camera_ = makeCamera({0, 0, 10}, {0, 0, 0});
    FrameSettings settings_;
};

TEST_F(Reasons, Dark) {
    SpotLight lamp = makeSpot({0, 3, 5}, {0, 0, 2}, 0.3);
    EXPECT_EQ(skippedOf(lamp).total(), 0);
    lamp.intensityCandela = 0.0;
    EXPECT_EQ(skippedOf(lamp).dark, 1);
}

TEST_F(Reasons, ALightMapWithoutLightIsDark) {
    SpotLight lamp = makeSpot({0, 3, 5}, {0, 0, 2}, 0.3);
    useLightMap(scene_, lamp, makeImage(8, 8, [](int, int) { return glm::vec4(0, 0, 0, 1); }));
    EXPECT_EQ(skippedOf(lamp).dark, 1);
}

TEST_F(Reasons, BehindTheCamera) {
    EXPECT_EQ(skippedOf(makeSpot({0, 0, 12}, {0, 0, 20}, 0.3)).behindCamera, 1);
    EXPECT_EQ(skippedOf(makeSpot({0, 0, 12}, {0, 0, 5}, 0.3)).total(), 0);
}

TEST_F(Reasons, OutOfRange) {
    SpotLight lamp = makeSpot({0, 30, 5}, {0, 0, 5}, 0.1);
    EXPECT_EQ(skippedOf(lamp).total(), 0);
    lamp.rangeMetres = 10.0;
    scene_.nodes[0].worldFromLocal[3].z = -60.0;
    EXPECT_EQ(skippedOf(lamp).outOfRange, 1);
    scene_.nodes[0].worldFromLocal[3].z = 0.0;
    settings_.haze.scatteringPerMetre = 0.0;
    EXPECT_EQ(skippedOf(makeSpot({0, 0, 5}, {0, 0, 0}, 0.1)).total(), 0);
    lamp = makeSpot({0, 0, 5}, {0, 0, 0}, 0.1);
    lamp.rangeMetres = 4.0;
    EXPECT_EQ(skippedOf(lamp).outOfRange, 1) << "the wall is 5 m away, and there is no haze";
}

TEST_F(Reasons, OutsideTheView) {
    const SpotLight lamp = makeSpot({40, 0, 5}, {40, 9, 5}, 0.1);
    EXPECT_EQ(skippedOf(lamp).total(), 0) << "it grazes the wall, far from what is seen of it";
    scene_.nodes.clear();
    EXPECT_EQ(skippedOf(lamp).outsideView, 1);
}

TEST_F(Reasons, BehindTheWall) {
    // Shining sideways behind the wall; towards it; and where there is no wall.
    EXPECT_EQ(skippedOf(makeSpot({0, 0, -5}, {5, 0, -6}, 0.1)).behindScene, 1);
    EXPECT_EQ(skippedOf(makeSpot({0, 0, -5}, {0, 0, 0}, 0.1)).total(), 0);
    SpotLight ending = makeSpot({0, 0, -5}, {0, 0, 0}, 0.1);
    ending.rangeMetres = 4.5;
    EXPECT_EQ(skippedOf(ending).behindScene, 1) << "its light ends before the wall";
    scene_.nodes[0].worldFromLocal[3].x = 55.0;
    EXPECT_EQ(skippedOf(makeSpot({0, 0, -5}, {5, 0, -6}, 0.1)).total(), 0);
}

TEST_F(Reasons, OnlyWhatIsOpaqueAndSeenHides) {
    const SpotLight lamp = makeSpot({0, 0, -5}, {5, 0, -6}, 0.1);
    scene_.materials[0].alphaMode = Material::AlphaMode::kBlend;
    EXPECT_EQ(skippedOf(lamp).total(), 0);
    scene_.materials[0].alphaMode = Material::AlphaMode::kMask;
    EXPECT_EQ(skippedOf(lamp).total(), 0);
    scene_.materials[0].alphaMode = Material::AlphaMode::kOpaque;
    EXPECT_EQ(skippedOf(lamp).behindScene, 1);
    // From behind the wall is not drawn, unless it has two sides.
    camera_ = makeCamera({0, 0, -10}, {0, 0, 0});
    const SpotLight before = makeSpot({0, 0, 5}, {5, 0, 6}, 0.1);
    EXPECT_EQ(skippedOf(before).total(), 0);
    scene_.materials[0].doubleSided = true;
    EXPECT_EQ(skippedOf(before).behindScene, 1);
    // A wall that the near plane cuts away hides nothing.
    camera_.nearMetres = 11.0;
    EXPECT_EQ(skippedOf(before).total(), 0);
}

TEST_F(Reasons, BeyondTheFarPlane) {
    scene_.nodes.clear();
    const SpotLight lamp = makeSpot({0, 0, -5}, {1, 0, -9}, 0.1);
    EXPECT_EQ(skippedOf(lamp).total(), 0);
    camera_.farMetres = 14.0;
    EXPECT_EQ(skippedOf(lamp).behindScene, 1);
    camera_.farMetres = 16.0;
    EXPECT_EQ(skippedOf(lamp).total(), 0);
}

TEST_F(Reasons, CastersAndMapsThatAreNotNeeded) {
    addShape(scene_, makeBox({9, 0, 4}, {10, 1, 5}), makeMaterial(glm::vec3(0.5F)));
    scene_.spotLights = {makeSpot({0, 1, 5}, {0, 1, 0}, 0.1), makeSpot({0, 1, 5}, {0, 1, 9}, 0.1)};
    const FramePlan made = plan();
    EXPECT_EQ(made.shadowMaps.layers, 1);
    EXPECT_EQ(made.shadowMapsNeedless, 1) << "it shines away from all there is";
    EXPECT_EQ(made.castersDrawn, 1);
    EXPECT_EQ(made.castersCulled, 1) << "the box is beside the cone";
}

TEST_F(Reasons, ABlackRimLeavesTilesAndCastersOut) {
    SpotLight lamp = makeSpot({0, 0, 5}, {0, -1, 5}, 0.5);
    lamp.rangeMetres = 3.0;
    const auto tiles = [&](double radius) {
        scene_.images.clear();
        useLightMap(scene_, lamp, makeImage(64, 64, [&](int x, int y) {
                        return std::hypot(x - 31.5, y - 31.5) < 32.0 * radius
                                   ? glm::vec4(1.0F)
                                   : glm::vec4(0, 0, 0, 1);
                    }));
        scene_.spotLights = {lamp};
        settings_.width = 640;
        settings_.height = 480;
        return plan().beamTilesDrawn();
    };
    const int whole = tiles(2.0);
    EXPECT_LT(tiles(0.5), 0.75 * whole);
    EXPECT_GT(tiles(0.5), 0.3 * whole);
    EXPECT_GT(plan().beamTilesTotal(), whole);
}

/// What a ray of the camera meets first, by every triangle of the scene: metres along it.
double firstSurface(const Scene& scene, const glm::dvec3& origin, const glm::dvec3& direction,
                    double nearest) {
    double first = kNowhere;
    for (const Node& node : scene.nodes) {
        const Primitive& primitive = scene.meshes[std::size_t(node.mesh)].primitives[0];
        const Material& material = scene.materials[std::size_t(primitive.material)];
        for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
            glm::dvec3 p[3];
            for (std::size_t c = 0; c < 3; ++c) {
                const glm::dvec3 local(primitive.positions[primitive.indices[i + c]]);
                p[c] = glm::dvec3(node.worldFromLocal * glm::dvec4(local, 1.0));
            }
            const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
            const double facing = glm::dot(normal, direction);
            if (facing == 0.0 || (facing > 0.0 && !material.doubleSided)) {
                continue;
            }
            const double t = glm::dot(normal, p[0] - origin) / facing;
            const glm::dvec3 at = origin + t * direction;
            bool inside = t > nearest && t < first;
            for (std::size_t c = 0; c < 3 && inside; ++c) {
                const glm::dvec3 edge = p[(c + 1) % 3] - p[c];
                inside = glm::dot(glm::cross(edge, at - p[c]), normal) >= 0.0;
            }
            first = inside ? t : first;
        }
    }
    return first;
}

/// Whether the lamp sends light to a point, were nothing in its way.
bool lights(const SpotLight& lamp, const LightMapTexture* map, const glm::dvec3& point) {
    const glm::dvec3 from = point - lamp.frame.position;
    const double depth = glm::dot(from, lamp.frame.forward());
    const glm::dvec2 slope(glm::dot(from, lamp.frame.right()) / depth,
                           glm::dot(from, lamp.frame.up()) / depth);
    const double tangent = std::tan(lamp.outerConeAngle);
    const double out = lamp.beamShape == BeamShape::kPyramid
                           ? std::max(std::abs(slope.x), std::abs(slope.y))
                           : glm::length(slope);
    if (depth <= 0.05 || out >= tangent || glm::length(from) >= lamp.rangeMetres) {
        return false;
    }
    const glm::dvec2 uv(0.5 + 0.5 * slope.x / tangent, 0.5 - 0.5 * slope.y / tangent);
    return map == nullptr || map->at(uv) != glm::dvec3(0.0);
}

/// Whether any ray of the camera meets the lamp's light, in the air or on the surface it ends on.
bool isSeen(const RandomStage& stage, const FrameSettings& settings, const SpotLight& lamp,
            const LightMapTexture* map) {
    const bool haze = settings.haze.scatteringPerMetre > 0.0;
    for (int y = 0; y < settings.height; ++y) {
        for (int x = 0; x < settings.width; ++x) {
            const PixelRay ray = pixelRay(stage.camera, settings.width, settings.height, x, y);
            const double near = stage.camera.nearMetres * ray.metresPerDepth;
            const double far = stage.camera.farMetres * ray.metresPerDepth;
            const double surface = firstSurface(stage.scene, ray.origin, ray.direction, near);
            const auto lit = [&](double t) {
                return lights(lamp, map, ray.origin + t * ray.direction);
            };
            if (surface < far && lit(surface)) {
                return true;
            }
            const double end = std::min({surface, far, 40.0});
            for (int s = 0; haze && s < 120; ++s) {
                if (lit(near + (end - near) * (s + 0.5) / 120.0)) {
                    return true;
                }
            }
        }
    }
    return false;
}

// Held against rays through every pixel, which know of no bounds, outlines or occluders.
TEST(SkippedLamps, AreNeverSeen) {
    FrameSettings settings;
    settings.width = 24;
    settings.height = 16;
    SkippedLamps all;
    int kept = 0;
    int keptUnseen = 0;
    for (unsigned seed = 0; seed < 250; ++seed) {
        const RandomStage stage(seed);
        settings.haze.scatteringPerMetre = seed % 3 == 0 ? 0.0 : 0.05;
        const FramePlan plan =
            planFrame(stage.scene, stage.camera, settings, {}, litRegions(stage.scene));
        std::vector<bool> isKept(stage.scene.spotLights.size(), false);
        for (const PlannedLamp& lamp : plan.lamps) {
            isKept[std::size_t(lamp.spot)] = true;
        }
        for (std::size_t i = 0; i < isKept.size(); ++i) {
            if (isKept[i] && seed % 10 != 0) {
                continue;
            }
            const SpotLight& lamp = stage.scene.spotLights[i];
            std::optional<LightMapTexture> map;
            if (lamp.lightMap) {
                map.emplace(stage.scene.images[std::size_t(lamp.lightMap->image)]);
            }
            const bool seen = isSeen(stage, settings, lamp, map ? &*map : nullptr);
            ASSERT_TRUE(isKept[i] || !seen) << "seed " << seed << ", lamp " << i;
            kept += isKept[i] ? 1 : 0;
            keptUnseen += isKept[i] && !seen ? 1 : 0;
        }
        all.dark += plan.skipped.dark;
        all.behindCamera += plan.skipped.behindCamera;
        all.behindScene += plan.skipped.behindScene;
        all.outOfRange += plan.skipped.outOfRange;
        all.outsideView += plan.skipped.outsideView;
    }
    std::printf(
        "skipped: %d dark, %d behind camera, %d behind scene, %d out of range, %d outside; "
        "%d of %d kept ones unseen\n",
        all.dark, all.behindCamera, all.behindScene, all.outOfRange, all.outsideView, keptUnseen,
        kept);
    // Every reason is met often, so that the test means something.
    EXPECT_GT(all.dark, 40);
    EXPECT_GT(all.behindCamera, 40);
    EXPECT_GT(all.behindScene, 40);
    EXPECT_GT(all.outOfRange, 40);
    EXPECT_GT(all.outsideView, 15);
}

}  // namespace
}  // namespace ribalta::test
