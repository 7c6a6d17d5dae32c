// Shadows of the sun: where they fall, against rays cast in double precision, and that lit surfaces
// do not shade themselves.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "gl/counters.h"
#include "gpu_test.h"
#include "reference/cast_rays.h"
#include "reference/surface_light.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

constexpr double kFar = 1e4;  // metres: beyond every caster

class SunShadow : public GpuTest {
  protected:
    SunShadow() {
        settings_ = measuringSettings(160, 120);
        settings_.sky.emplace();
        settings_.sky->orders = {1, false};
        // Air that takes and gives no light, over ground that sends none back: what is left is the
        // sun's light, all or nothing.
        Atmosphere& air = settings_.sky->air;
        air.rayleighScatteringPerMetre = glm::dvec3(0.0);
        air.mieScatteringPerMetre = glm::dvec3(0.0);
        air.mieExtinctionPerMetre = glm::dvec3(0.0);
        air.groundAlbedo = glm::dvec3(0.0);
    }
    void add(Primitive primitive) {
        addShape(scene_, std::move(primitive), makeMaterial(glm::vec3(0.7F)));
    }
    void setSun(double elevation, double around) {
        settings_.sky->towardsSun = {std::cos(elevation * kDegree) * std::cos(around * kDegree),
                                     std::sin(elevation * kDegree),
                                     std::cos(elevation * kDegree) * std::sin(around * kDegree)};
    }
    /// A yard of slabs, posts, a ball and a wall without thickness, on a floor of 400 m.
    void buildYard() {
        add(makeQuad({0, 0, 0}, {200, 0, 0}, {0, 0, -200}));
        add(makeBox({-2, 0, -2}, {-1, 3, -1}));
        add(makeBox({1, 2.4F, -3}, {5, 2.6F, 1}));
        for (const float x : {1.05F, 4.85F}) {
            add(makeBox({x, 0, -2.9F}, {x + 0.1F, 2.4F, -2.8F}));
            add(makeBox({x, 0, 0.8F}, {x + 0.1F, 2.4F, 0.9F}));
        }
        add(makeSphere({-0.5F, 1, 1.5F}, 0.5F, 96));
        for (int i = 0; i < 6; ++i) {
            const auto far = float(12 << i);
            add(makeBox({-0.3F * far, 0, -far}, {-0.2F * far, 0.25F * far, -0.9F * far}));
        }
        Material sheet = makeMaterial(glm::vec3(0.7F));
        sheet.doubleSided = true;
        addShape(scene_, makeQuad({-4, 1, 0}, {0, 0, 1}, {0, 1, 0}), sheet);
    }

    /// What the picture shows and what rays find, by pixel.
    struct Tally {
        int lit = 0;
        int dark = 0;
        int unsure = 0;  ///< within the half-shadow and what texels and bias move
        int wrong = 0;
    };
    Tally compareWithRays() {
        Renderer renderer(scene_);
        const FramePlan& plan = renderer.draw(camera_, settings_);
        EXPECT_TRUE(plan.sunShadow.has_value());
        const Frame3 frame = readBack(renderer, {.depth = true});
        Scene open = scene_;
        DirectionalLight& sun = open.directionalLights.emplace_back();
        sun.direction = -settings_.sky->towardsSun;
        sun.illuminanceLux = settings_.sky->air.sunIlluminanceLux.x;
        const std::vector<PlacedSurface> surfaces = placeSurfaces(scene_, camera_);
        const MaterialTextures textures(scene_);
        const RayCaster caster(surfaces, textures, camera_.frame.position);
        const SurfaceLight light(open, {}, caster, settings_.haze, 0.0);
        Tally tally;
        for (int y = 0; y < settings_.height; ++y) {
            for (int x = 0; x < settings_.width; ++x) {
                const PixelRay ray = pixelRay(camera_, settings_.width, settings_.height, x, y);
                Sight sight;
                caster.look(ray.origin, ray.direction, 0.1, 1e6, sight);
                const double depth = frame.depth(x, y);
                if (!sight.opaque || !std::isfinite(depth) ||
                    std::abs(sight.opaque->distance - depth * ray.metresPerDepth) >
                        1e-4 * sight.opaque->distance ||
                    isEdge(*sight.opaque)) {
                    continue;
                }
                const ShadedPoint point = shadedPoint(surfaces[sight.opaque->surface], textures,
                                                      *sight.opaque, ray.origin, ray.direction);
                const double expected = light.radiance(point).x;
                if (expected <= 1.0) {
                    EXPECT_LE(frame.color(x, y).x, 1.0)
                        << x << ", " << y << " at " << point.position.x << ", " << point.position.y
                        << ", " << point.position.z;
                    continue;  // looks away from the sun
                }
                const double share = frame.color(x, y).x / expected;
                const int seen = seenFrom(*plan.sunShadow, caster, point);
                tally.lit += seen == 1 ? 1 : 0;
                tally.dark += seen == 0 ? 1 : 0;
                tally.unsure += seen < 0 ? 1 : 0;
                EXPECT_LT(share, 1.01);
                if ((seen == 1 && share < 0.99) || (seen == 0 && share > 0.01)) {
                    ++tally.wrong;
                    if (tally.wrong < 5) {
                        ADD_FAILURE() << "pixel " << x << ", " << y << " at " << point.position.x
                                      << ", " << point.position.y << ", " << point.position.z
                                      << " has " << share << " of its light, expected " << seen;
                    }
                }
            }
        }
        return tally;
    }

    /// Where the picture may show one face and the ray meet the next one.
    static bool isEdge(const SurfaceHit& hit) {
        return std::min({hit.weights.x, hit.weights.y, hit.weights.z}) < 1e-3;
    }

    /// 1, 0 where all of a bundle of rays to the sun's disc see it, or none does; else -1. The
    /// bundle is as wide as the map is vague there: its filter of a texel, half a texel of
    /// rasterising, and two and a half by which points are moved off their surface, along it and
    /// towards the sun.
    int seenFrom(const SunShadowWork& work, const RayCaster& caster, const ShadedPoint& point) {
        const glm::dvec3& sun = settings_.sky->towardsSun;
        const glm::dmat3 world = glm::transpose(work.sunFromWorld);
        double texel = work.texelMetres(work.cascades.back());
        for (const SunCascade& cascade : work.cascades) {
            const glm::dvec3 place = work.sunFromWorld * point.position - cascade.middle;
            const double margin = kSunMapMargin * work.texelMetres(cascade);
            // Wholly within: not where two are blended.
            if (std::max(std::abs(place.x), std::abs(place.y)) < 0.94 * cascade.halfSide - margin &&
                place.z > margin + 0.06 * cascade.halfSide) {
                texel = work.texelMetres(cascade);
                break;
            }
        }
        const double side = glm::dot(sun, point.geometric) < 0.0 ? -1.0 : 1.0;
        const glm::dvec3 from = point.position + side * 1e-6 * point.geometric;
        int lit = 0;
        int rays = 0;
        for (const double disc : {0.0, settings_.sky->air.sunAngularRadius}) {
            for (int i = 0; i < 12; ++i) {
                const double turn = i / 6.0 * std::numbers::pi;
                const glm::dvec3 aside = std::cos(turn) * world[0] + std::sin(turn) * world[1];
                const glm::dvec3 towards = glm::normalize(sun + 1.3 * disc * aside);
                for (const double wide : {0.0, 1.0, 2.0, 3.0, 4.0}) {
                    // Along the surface's plane.
                    glm::dvec3 shift = wide * texel * aside;
                    shift -=
                        sun * (glm::dot(shift, point.geometric) / glm::dot(sun, point.geometric));
                    const glm::dvec3 start = from + shift;
                    lit += caster.isBlocked(start, start + kFar * towards) ? 0 : 1;
                    ++rays;
                }
            }
        }
        return lit == rays ? 1 : lit == 0 ? 0 : -1;
    }

    Scene scene_;
    Camera camera_ = makeCamera({2, 3, 9}, {0, 1, 0}, 0.9);
    FrameSettings settings_;
};

TEST_F(SunShadow, FallWhereRaysSay) {
    buildYard();
    for (const double elevation : {5.0, 20.0, 50.0, 89.0}) {
        for (const double around : {30.0, 200.0}) {
            SCOPED_TRACE(std::to_string(elevation) + ", " + std::to_string(around));
            setSun(elevation, around);
            const Tally tally = compareWithRays();
            EXPECT_EQ(tally.wrong, 0);
            EXPECT_GT(tally.lit, 2000);
            EXPECT_GT(tally.dark, 100);
            EXPECT_LT(tally.unsure, tally.lit + tally.dark);
        }
    }
}

TEST_F(SunShadow, FallWhereRaysSayFromAboveAndWithoutPerspective) {
    buildYard();
    setSun(35.0, 250.0);
    camera_ = makeCamera({0, 60, 50}, {0, 0, -10}, 0.9);
    EXPECT_EQ(compareWithRays().wrong, 0);
    camera_ = makeCamera({8, 8, 8}, {0, 0, 0});
    camera_.lens = OrthographicLens{6.0, 4.5};
    camera_.farMetres = 40.0;
    const Tally tally = compareWithRays();
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.dark, 500);
}

TEST_F(SunShadow, LitSurfacesDoNotShadeThemselves) {
    add(makeQuad({0, 0, 0}, {2000, 0, 0}, {0, 0, -2000}));
    add(makeSphere({0, 2, 0}, 1.5F, 128));
    for (const double elevation : {1.0, 3.0, 10.0, 45.0, 90.0}) {
        for (const double around : {0.0, 40.0, 180.0}) {
            setSun(elevation, around);
            const Frame3 frame = drawOnce(scene_, camera_, settings_);
            Scene open = scene_;
            for (Material& material : open.materials) {
                material.alphaMode = Material::AlphaMode::kBlend;
            }
            const Frame3 bright = drawOnce(open, camera_, settings_);
            int lit = 0;
            int floor = 0;
            for (int y = 0; y < settings_.height; ++y) {
                for (int x = 0; x < settings_.width; ++x) {
                    const PixelRay ray = pixelRay(camera_, settings_.width, settings_.height, x, y);
                    const glm::dvec3 way = glm::dvec3(0, 2, 0) - ray.origin;
                    const double along = glm::dot(way, ray.direction);
                    const double inside = 1.5 * 1.5 - glm::dot(way, way) + along * along;
                    if (inside > 0.0) {
                        const glm::dvec3 normal =
                            (ray.origin + (along - std::sqrt(inside)) * ray.direction -
                             glm::dvec3(0, 2, 0)) /
                            1.5;
                        if (glm::dot(normal, settings_.sky->towardsSun) > 0.15 && inside > 0.05) {
                            ++lit;
                            ASSERT_GT(frame.color(x, y).x, 0.99 * bright.color(x, y).x)
                                << "ball, " << elevation << ", " << x << ", " << y;
                        }
                        continue;
                    }
                    // The floor, out of the ball's shadow and the texels that it touches.
                    const double t = -ray.origin.y / ray.direction.y;
                    const glm::dvec3 point = ray.origin + t * ray.direction;
                    const double from = glm::length(
                        glm::cross(point - glm::dvec3(0, 2, 0), settings_.sky->towardsSun));
                    if (t > 0.0 && t < 600.0 && from > 1.6 + 0.025 * t) {
                        ++floor;
                        ASSERT_NEAR(frame.color(x, y).x / bright.color(x, y).x, 1.0, 0.01)
                            << "floor, " << elevation << ", " << x << ", " << y << ", " << t;
                    }
                }
            }
            EXPECT_GT(floor, 2000);
            EXPECT_GT(lit + int(around > 100.0) * 1000, 100);
        }
    }
}

TEST_F(SunShadow, TheHalfShadowIsAsWideAsTheSunsDisc) {
    // The straight edge of a roof 5 m above the floor: its shadow fades over 2 * 5 m * tan 0.2666
    // degrees, seen from above by pixels of 2.5 mm.
    add(makeQuad({0, 0, 0}, {20, 0, 0}, {0, 0, -20}));
    add(makeBox({-10, 5, -10}, {0, 5.05F, 10}));
    settings_.sky->towardsSun = {0.0, 1.0, 0.0};
    camera_ = makeCamera({0.0, 1.5, 0.0}, {0.0, 0.0, 0.0}, 2.0 * std::atan(0.1));
    const Frame3 frame = drawOnce(scene_, camera_, settings_);
    // The camera looks down; which way is up in the picture is its own affair.
    std::vector<double> row;
    const bool level = std::abs(camera_.frame.right().x) > 0.5;
    for (int i = 0; i < (level ? settings_.width : settings_.height); ++i) {
        row.push_back(level ? frame.color(i, 60).x : frame.color(80, i).x);
    }
    if (row.front() > row.back()) {
        std::reverse(row.begin(), row.end());
    }
    EXPECT_LT(row.front(), 1e-6);
    const double full = row.back();
    // Between a tenth and nine tenths: of a disc that is 0.687 of its width.
    const auto at = [&](double share) {
        return double(std::lower_bound(row.begin(), row.end(), share * full) - row.begin());
    };
    const double metres = (at(0.9) - at(0.1)) * 0.0025;
    const double expected = 0.687 * 2.0 * 5.0 * std::tan(settings_.sky->air.sunAngularRadius);
    EXPECT_NEAR(metres / expected, 1.0, 0.25) << metres;
}

TEST_F(SunShadow, FarFromTheOriginTheyAreTheSame) {
    buildYard();
    setSun(30.0, 60.0);
    const Frame3 here = drawOnce(scene_, camera_, settings_);
    const glm::dvec3 away(3000.0, 0.0, -5000.0);
    for (Node& node : scene_.nodes) {
        node.worldFromLocal[3] += glm::dvec4(away, 0.0);
    }
    camera_.frame.position += away;
    const Frame3 there = drawOnce(scene_, camera_, settings_);
    int off = 0;
    for (int y = 0; y < settings_.height; ++y) {
        for (int x = 0; x < settings_.width; ++x) {
            off += std::abs(there.color(x, y).x - here.color(x, y).x) > 0.1 * here.color(x, y).x + 1
                       ? 1
                       : 0;
        }
    }
    EXPECT_LT(off, settings_.width * settings_.height / 50) << "edges, whose texels lie elsewhere";
}

TEST_F(SunShadow, AKeptMapDrawsNothing) {
    buildYard();
    setSun(30.0, 60.0);
    Renderer renderer(scene_);
    const int maps = renderer.draw(camera_, settings_).sunShadow->drawn();
    EXPECT_GT(maps, 1);
    const Frame3 first = readBack(renderer);
    renderer.redrawNextFrame();
    const GlCounters before = glCounters();
    EXPECT_EQ(renderer.draw(camera_, settings_).sunShadow->drawn(), 0);
    const std::uint64_t kept = glCounters().drawCalls - before.drawCalls;
    EXPECT_EQ(readBack(renderer).image.values, first.image.values);
    renderer.forget();
    renderer.draw(camera_, settings_);
    EXPECT_GT(glCounters().drawCalls - before.drawCalls, 2 * kept + std::uint64_t(maps));
}

}  // namespace
}  // namespace ribalta::test
