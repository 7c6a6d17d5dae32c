// The shadow maps' pyramid: its texels against all that they stand for, and pictures and counts of
// beams whose runs of sheets are judged by it.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "gpu_test.h"
#include "render/read_shadow_maps.h"
#include "support/random_stage.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

FrameSettings settingsWith(int planes, BeamMethod method) {
    FrameSettings settings = measuringSettings(72, 54);
    settings.haze.scatteringPerMetre = 0.05;
    settings.beams.method = method;
    settings.beams.planes = planes;
    settings.beams.sheetsForPyramid = 1;
    return settings;
}

class ShadowPyramid : public GpuTest {};

TEST_F(ShadowPyramid, TexelsAreTheLeastAndTheGreatestOfTheirBlocks) {
    Scene scene;
    addShape(scene, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}), makeMaterial(glm::vec3(0.5F)));
    addShape(scene, makeSphere({0.3F, 2, 0.1F}, 0.4F, 16), makeMaterial(glm::vec3(0.5F)));
    scene.spotLights.push_back(makeSpot({-3, 5, 1}, {0, 0, 0}, 0.3));
    scene.spotLights.push_back(makeSpot({2, 4, 0}, {0, 1, 0}, 0.2));
    Renderer renderer(scene);
    renderer.draw(makeCamera({0, 2, 8}, {0, 1, 0}), settingsWith(8, BeamMethod::kClipped));
    const Texture2D& pyramid = renderer.shadowPyramid();
    ASSERT_TRUE(bool(pyramid));
    const std::vector<ShadowMapImage> maps = readShadowMaps(renderer, scene);
    ASSERT_EQ(maps.size(), 2U);
    const int side = maps[0].side;
    ASSERT_EQ(pyramid.size().levels, int(std::log2(side / 4)) + 1);
    for (std::size_t m = 0; m < maps.size(); ++m) {
        const int layer = renderer.lastPlan().lamps[m].shadowLayer;
        for (int level = 0; level < pyramid.size().levels; ++level) {
            const int block = 4 << level;
            const int across = side / block;
            std::vector<glm::vec2> texels(std::size_t(across) * std::size_t(across));
            glGetTextureSubImage(pyramid.name(), level, 0, 0, layer, across, across, 1, GL_RG,
                                 GL_FLOAT, GLsizei(texels.size() * sizeof(glm::vec2)),
                                 texels.data());
            const int width = level == 0 ? block : 2 * block;
            int wrong = 0;
            for (int t = 0; t < across * across; ++t) {
                const int x0 = t % across * block;
                const int y0 = t / across * block;
                float least = 2.0F;
                float greatest = -1.0F;
                for (int y = y0; y < std::min(y0 + width, side); ++y) {
                    for (int x = x0; x < std::min(x0 + width, side); ++x) {
                        const float depth =
                            maps[m].depths[std::size_t(y) * std::size_t(side) + std::size_t(x)];
                        least = std::min(least, depth);
                        greatest = std::max(greatest, depth);
                    }
                }
                wrong += texels[std::size_t(t)] == glm::vec2(least, greatest) ? 0 : 1;
            }
            EXPECT_EQ(wrong, 0) << "level " << level << " of " << across * across;
        }
    }
}

// A run judged lit in which a sheet is dark, or the other way around, would show: no light at all
// may differ, from one sheet to more than one set of them.
TEST_F(ShadowPyramid, PicturesAreTheSameToTheBit) {
    std::uint64_t lit = 0;
    std::uint64_t dark = 0;
    std::uint64_t mixed = 0;
    int casting = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const RandomStage stage(seed);
        const BeamMethod method = seed % 4 == 0 ? BeamMethod::kAdaptive : BeamMethod::kClipped;
        constexpr int kPlanes[] = {1, 2, 7, 31, 32, 33, 70};
        FrameSettings settings = settingsWith(kPlanes[seed % 7], method);
        Frame3 with = drawOnce(stage.scene, stage.camera, settings);
        settings.beams.sheetsForPyramid = 1000;
        const Frame3 without = drawOnce(stage.scene, stage.camera, settings);
        EXPECT_EQ(with.image.values, without.image.values) << "seed " << seed;
        settings.beams.sheetsForPyramid = 1;
        settings.countRuns = true;
        Renderer renderer(stage.scene);
        renderer.draw(stage.camera, settings);
        EXPECT_EQ(readBack(renderer).image.values, with.image.values) << "counted, seed " << seed;
        if (const auto runs = renderer.runCounts()) {
            lit += runs->lit;
            dark += runs->dark;
            mixed += runs->mixed;
            ++casting;
        }
    }
    std::printf("runs lit %lu, dark %lu, mixed %lu\n", (unsigned long)lit, (unsigned long)dark,
                (unsigned long)mixed);
    EXPECT_GT(casting, 20);
    EXPECT_GT(lit, 10000U);
    EXPECT_GT(dark, 1000U);
    EXPECT_GT(mixed, 1000U);
}

// Looking through a beam above and below a plate that fills it: sheets between lamp and plate are
// lit, those behind it dark, and only where rays pass its edge is any texel looked at.
TEST_F(ShadowPyramid, RunsOfOneKindLookAtNoTexel) {
    Scene scene;
    addShape(scene, makeBox({-3, 2.0F, -3}, {3, 2.1F, 3}), makeMaterial(glm::vec3(0.5F)));
    scene.spotLights.push_back(makeSpot({0, 5, 0}, {0, 0, 0}, 0.2));
    FrameSettings settings = settingsWith(32, BeamMethod::kClipped);
    settings.countRuns = true;
    const auto runsAt = [&](double height) {
        Renderer renderer(scene);
        renderer.draw(makeCamera({0, height, 6}, {0, height, 0}, 0.2), settings);
        return renderer.runCounts();
    };
    const auto above = runsAt(3.5);
    const auto below = runsAt(0.9);
    ASSERT_TRUE(above && below);
    EXPECT_GT(above->lit, 1000U);
    EXPECT_EQ(above->dark, 0U);
    EXPECT_EQ(above->mixed, 0U);
    EXPECT_EQ(above->fetches, 0U);
    EXPECT_GT(below->dark, 1000U);
    EXPECT_EQ(below->lit, 0U);
    EXPECT_EQ(below->mixed, 0U);
    EXPECT_EQ(below->fetches, 0U);
    // The plate shrunk to half of the beam: now some are looked at.
    scene.nodes[0].worldFromLocal[0][0] = 0.1;
    const auto half = runsAt(0.9);
    ASSERT_TRUE(half);
    EXPECT_GT(half->mixed, 0U);
    EXPECT_GT(half->fetches, half->mixed);
}

TEST_F(ShadowPyramid, IsNotMadeWithoutNeed) {
    Scene scene;
    addShape(scene, makeQuad({0, 0, 0}, {5, 0, 0}, {0, 0, -5}), makeMaterial(glm::vec3(0.5F)));
    scene.spotLights.push_back(makeSpot({0, 5, 0}, {0, 0, 0}, 0.3));
    const Camera camera = makeCamera({0, 2, 8}, {0, 1, 0});
    FrameSettings settings = settingsWith(8, BeamMethod::kClipped);
    settings.countRuns = true;
    settings.beams.sheetsForPyramid = 9;
    Renderer renderer(scene);
    renderer.draw(camera, settings);
    EXPECT_FALSE(bool(renderer.shadowPyramid()));
    EXPECT_FALSE(renderer.runCounts());
    settings.beams.sheetsForPyramid = 8;
    renderer.draw(camera, settings);
    EXPECT_TRUE(bool(renderer.shadowPyramid()));
    EXPECT_TRUE(renderer.runCounts());
}

}  // namespace
}  // namespace ribalta::test
