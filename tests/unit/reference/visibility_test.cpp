// Shadows on view rays: triangles against balls and boxes by their equations and against Embree's
// rays, texels of shadow maps against looking each point up.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "reference/cast_rays.h"
#include "reference/shadow_map_visibility.h"
#include "reference/triangle_shadows.h"
#include "support/stage.h"

namespace ribalta {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A scene's triangles, ready to be asked.
struct Traced {
    std::vector<PlacedSurface> surfaces;
    MaterialTextures textures;
    RayCaster caster;
    TriangleShadows shadows;

    explicit Traced(const Scene& scene, const glm::dvec3& origin = {0.0, 0.0, 0.0})
        : surfaces(placeSurfaces(scene, Camera{})),
          textures(scene),
          caster(surfaces, textures, origin),
          shadows(surfaces, textures) {}
};

/// Rays that cross a lamp's beam, ended at random.
std::vector<BeamSegment> randomSegments(const BeamLamp& lamp, int count) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> range(-4.0, 4.0);
    std::vector<BeamSegment> segments;
    while (int(segments.size()) < count) {
        const glm::dvec3 from(range(random), range(random), range(random));
        const glm::dvec3 to(range(random), range(random), range(random));
        if (auto segment = BeamSegment::make(lamp, lamp.light.frame.position + from,
                                             glm::normalize(to - from), {0.0, 8.0})) {
            segments.push_back(*segment);
        }
    }
    return segments;
}

bool holds(const std::vector<Interval>& stretches, double x) {
    return std::any_of(stretches.begin(), stretches.end(), [x](const Interval& stretch) {
        return x >= stretch.first && x <= stretch.last;
    });
}

double distanceToEdge(const std::vector<Interval>& stretches, double x) {
    double nearest = kNever;
    for (const Interval& stretch : stretches) {
        nearest = std::min({nearest, std::abs(x - stretch.first), std::abs(x - stretch.last)});
    }
    return nearest;
}

glm::dvec3 pointAt(const BeamSegment& segment, double x) {
    return segment.lamp.light.frame.position + segment.worldOrigin +
           segment.distanceAt(x) * segment.worldDirection;
}

BeamLamp sideLamp() {
    return {test::makeSpot({-3.0, 1.0, 0.5}, {0.0, 0.0, 0.0}, 0.6), 0, nullptr};
}

void expectStretchesAreAscending(const std::vector<Interval>& stretches) {
    double last = -1.0;
    for (const Interval& stretch : stretches) {
        EXPECT_GT(stretch.last, stretch.first);
        EXPECT_GT(stretch.first, last);
        last = stretch.last;
    }
}

/// Where a segment from `a` to `b` enters a box around 0; kNever where it misses.
double boxCrossing(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& half) {
    double first = 0.0;
    double last = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = b[axis] - a[axis];
        const double s0 = (-half[axis] - a[axis]) / way;
        const double s1 = (half[axis] - a[axis]) / way;
        first = std::max(first, std::min(s0, s1));
        last = std::min(last, std::max(s0, s1));
    }
    return first <= last ? first : kNever;
}

TEST(TriangleShadows, ABoxHidesWhatItsEquationSays) {
    Scene scene;
    const glm::dvec3 half(0.4, 0.7, 0.3);
    test::addShape(scene, test::makeBox(-glm::vec3(half), glm::vec3(half)),
                   test::makeMaterial(glm::vec3(0.5F)));
    const Traced traced(scene);
    const BeamLamp lamp = sideLamp();
    int dark = 0;
    for (const BeamSegment& segment : randomSegments(lamp, 2000)) {
        std::vector<Interval> lit;
        traced.shadows.findLit(segment, lit);
        expectStretchesAreAscending(lit);
        for (int i = 0; i < 40; ++i) {
            const double x = (i + 0.5) / 40.0;
            const double crossing =
                boxCrossing(lamp.light.frame.position, pointAt(segment, x), half + 1e-7);
            if (distanceToEdge(lit, x) > 1e-4) {
                dark += holds(lit, x) ? 0 : 1;
                EXPECT_EQ(holds(lit, x), crossing == kNever) << "x " << x;
            }
        }
    }
    EXPECT_GT(dark, 1000);
}

TEST(TriangleShadows, EdgesOfABoxAreExact) {
    // The lamp shines along +X past the box's face y = 1 at a ray along +Y behind it.
    Scene scene;
    test::addShape(scene, test::makeBox({-0.5F, -1.0F, -1.0F}, {0.5F, 1.0F, 1.0F}),
                   test::makeMaterial(glm::vec3(0.5F)));
    const Traced traced(scene);
    const BeamLamp lamp(test::makeSpot({-4.0, 0.0, 0.1}, {0.0, 0.0, 0.1}, 0.9), 0, nullptr);
    const auto segment = BeamSegment::make(lamp, {4.0, -6.0, 0.1}, {0.0, 1.0, 0.0}, {0.0, 12.0});
    ASSERT_TRUE(segment);
    std::vector<Interval> lit;
    traced.shadows.findLit(*segment, lit);
    ASSERT_EQ(lit.size(), 2U);
    // Through (-0.5, 1) from x = -4 to x = 4: y = 8 / 3.5.
    EXPECT_NEAR(segment->distanceAt(lit[0].last) - 6.0, -8.0 / 3.5, 1e-9);
    EXPECT_NEAR(segment->distanceAt(lit[1].first) - 6.0, 8.0 / 3.5, 1e-9);
}

TEST(TriangleShadows, AgreeWithEmbreesRays) {
    for (const glm::dvec3& offset : {glm::dvec3(0.0), glm::dvec3(1e5, -3e4, 2e5)}) {
        Scene scene;
        const glm::dmat4 place = glm::translate(glm::dmat4(1.0), offset);
        test::addShape(scene, test::makeSphere({0.2F, 0.1F, -0.1F}, 0.8F, 24),
                       test::makeMaterial(glm::vec3(0.5F)), place);
        test::addShape(scene, test::makeBox({0.9F, -2.0F, -0.2F}, {1.0F, 2.0F, 0.2F}),
                       test::makeMaterial(glm::vec3(0.5F)), place);
        const Traced traced(scene, offset);
        SpotLight light = sideLamp().light;
        light.frame.position += offset;
        const BeamLamp lamp(light, 0, nullptr);
        int dark = 0;
        for (const BeamSegment& segment : randomSegments(lamp, 2000)) {
            std::vector<Interval> lit;
            traced.shadows.findLit(segment, lit);
            for (int i = 0; i < 20; ++i) {
                const double x = (i + 0.5) / 20.0;
                if (distanceToEdge(lit, x) > 1e-4) {
                    const bool blocked =
                        traced.caster.isBlocked(pointAt(segment, x), light.frame.position);
                    dark += blocked ? 1 : 0;
                    EXPECT_EQ(holds(lit, x), !blocked) << "x " << x;
                }
            }
        }
        EXPECT_GT(dark, 1000);
    }
}

TEST(TriangleShadows, MasksLetLightThroughTheirHolesAndBlendedSurfacesCastNone) {
    Scene scene;
    Material masked = test::makeMaterial(glm::vec3(0.5F));
    masked.alphaMode = Material::AlphaMode::kMask;
    masked.baseColorTexture = TextureSlot{0, 0, glm::mat3(1.0F)};
    // Left half there, right half not; the edge of the two lies at u = 0.5.
    scene.images.push_back(test::makeImage(
        2, 1, [](int x, int) { return glm::vec4(1.0F, 1.0F, 1.0F, x == 0 ? 1.0F : 0.0F); }));
    Texture texture{0, {}};
    texture.sampler.wrapS = Sampler::Wrap::kClampToEdge;
    scene.textures.push_back(texture);
    test::addShape(scene, test::makeQuad({0, 0, 0}, {0, 0, -1}, {0, 1, 0}), masked);
    Material glass = test::makeMaterial(glm::vec3(0.5F));
    glass.alphaMode = Material::AlphaMode::kBlend;
    test::addShape(scene, test::makeQuad({-1, 0, 0}, {0, 0, -1}, {0, 1, 0}), glass);
    const Traced traced(scene);
    const BeamLamp lamp(test::makeSpot({-4.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.8), 0, nullptr);
    const auto segment = BeamSegment::make(lamp, {4.0, 0.3, -7.0}, {0.0, 0.0, 1.0}, {0.0, 14.0});
    ASSERT_TRUE(segment);
    std::vector<Interval> lit;
    traced.shadows.findLit(*segment, lit);
    // u grows towards -Z: z in 0..1 at the quad is there, which hides z in 0..2 at twice the way.
    ASSERT_EQ(lit.size(), 2U);
    EXPECT_NEAR(segment->distanceAt(lit[0].last) - 7.0, 0.0, 1e-6);
    EXPECT_NEAR(segment->distanceAt(lit[1].first) - 7.0, 2.0, 1e-6);
}

TEST(RayCaster, SeesABallWhereItsEquationSays) {
    Scene scene;
    test::addShape(scene, test::makeSphere({0.0F, 0.0F, -5.0F}, 1.0F, 400),
                   test::makeMaterial(glm::vec3(0.5F)));
    const Traced traced(scene);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> range(-0.3, 0.3);
    Sight sight;
    int hits = 0;
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(range(random), range(random), -1.0));
        traced.caster.look({0.0, 0.0, 0.0}, direction, 0.0, kNever, sight);
        const double along = glm::dot(direction, glm::dvec3(0.0, 0.0, -5.0));
        const double square = 1.0 - (25.0 - along * along);
        if (std::abs(square) < 1e-3) {
            continue;
        }
        ASSERT_EQ(sight.opaque.has_value(), square > 0.0);
        if (sight.opaque) {
            ++hits;
            EXPECT_TRUE(sight.opaque->front);
            EXPECT_NEAR(sight.opaque->distance, along - std::sqrt(square), 4e-3);
        }
    }
    EXPECT_GT(hits, 1000);
}

TEST(RayCaster, PassesBackFacesAndGathersBlendedSurfaces) {
    Scene scene;
    const auto add = [&](float z, bool away, Material material) {
        const glm::vec3 up(0.0F, away ? -1.0F : 1.0F, 0.0F);
        test::addShape(scene, test::makeQuad({0, 0, z}, {1, 0, 0}, up), material);
    };
    Material plain = test::makeMaterial(glm::vec3(0.5F));
    Material glass = plain;
    glass.alphaMode = Material::AlphaMode::kBlend;
    add(-2.0F, true, plain);
    add(-3.0F, false, glass);
    add(-4.0F, false, glass);
    add(-5.0F, false, plain);
    add(-6.0F, false, glass);
    const Traced traced(scene);
    Sight sight;
    traced.caster.look({0.1, 0.2, 0.0}, {0.0, 0.0, -1.0}, 0.0, kNever, sight);
    ASSERT_TRUE(sight.opaque);
    EXPECT_NEAR(sight.opaque->distance, 5.0, 1e-12);
    ASSERT_EQ(sight.blended.size(), 2U);
    // Drawn far to near.
    EXPECT_NEAR(sight.blended[0].distance, 4.0, 1e-12);
    EXPECT_NEAR(sight.blended[1].distance, 3.0, 1e-12);
    // A back face is not seen, but casts.
    EXPECT_TRUE(traced.caster.isBlocked({0.1, 0.2, 0.0}, {0.1, 0.2, -2.5}));
    EXPECT_FALSE(traced.caster.isBlocked({0.1, 0.2, -2.5}, {0.1, 0.2, -4.5}));
    traced.caster.look({0.1, 0.2, 0.0}, {0.0, 0.0, -1.0}, 0.0, 4.5, sight);
    EXPECT_FALSE(sight.opaque);
}

TEST(ShadowMapVisibility, IsWhatLookingUpEachPointGives) {
    DrawnShadowMap map;
    map.side = 64;
    map.inverseTan = 1.2;
    map.nearMetres = 0.05;
    std::mt19937_64 random(17);
    std::uniform_real_distribution<float> depth(0.0F, 0.05F);
    for (int i = 0; i < map.side * map.side; ++i) {
        map.depths.push_back(i % 3 == 0 ? 0.0F : depth(random));
    }
    const std::vector<std::optional<DrawnShadowMap>> maps = {map};
    const ShadowMapVisibility visibility(maps);
    const BeamLamp lamp = sideLamp();
    int dark = 0;
    int looked = 0;
    for (const BeamSegment& segment : randomSegments(lamp, 500)) {
        std::vector<Interval> lit;
        visibility.findLit(segment, lit);
        for (int i = 0; i < 200; ++i) {
            const double x = (i + 0.37) / 200.0;
            const glm::dvec3 place = lamp.toBeam(pointAt(segment, x) - lamp.light.frame.position);
            const glm::dvec2 texel =
                (0.5 + 0.5 * map.inverseTan * glm::dvec2(place) / place.z) * double(map.side);
            const auto index = std::size_t(texel.y) * 64U + std::size_t(texel.x);
            const bool expected = double(map.depths[index]) <= map.nearMetres / place.z;
            if (distanceToEdge(lit, x) > 1e-9) {
                ++looked;
                dark += expected ? 0 : 1;
                EXPECT_EQ(holds(lit, x), expected);
            }
        }
    }
    EXPECT_GT(looked, 99000);
    EXPECT_GT(dark, 10000);
}

TEST(ShadowMapVisibility, ALampWithoutMapHasNoShadow) {
    const std::vector<std::optional<DrawnShadowMap>> none(1);
    const BeamLamp lamp = sideLamp();
    std::vector<Interval> lit;
    ShadowMapVisibility(none).findLit(randomSegments(lamp, 1)[0], lit);
    ASSERT_EQ(lit.size(), 1U);
    EXPECT_EQ(lit[0].length(), 1.0);
}

}  // namespace
}  // namespace ribalta
