// Clipping rays to beams against the definition of a beam, sampled; the same code in float against
// double; projective placement by its identities.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "optics/shader_lib.h"
#include "shader_lib_float.h"

namespace ribalta {
namespace {

constexpr double kLens = 0.05;
constexpr double kRadian = std::numbers::pi / 180.0;

enum class Shape { kCone, kPyramid };

struct Beam {
    Shape shape = Shape::kCone;
    double halfAngle = 0.3;
    double zFar = 1e30;

    /// How far inside the beam a point is, metres, roughly; negative outside.
    double depthInside(const glm::dvec3& p) const {
        const double width = p.z * std::tan(halfAngle);
        const double side = shape == Shape::kCone ? width - std::hypot(p.x, p.y)
                                                  : width - std::max(std::abs(p.x), std::abs(p.y));
        return std::min({side * std::cos(halfAngle), p.z - kLens, zFar - p.z});
    }
};

struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, 1.0};
    double t0 = 0.0;
    double t1 = 100.0;

    glm::dvec3 at(double t) const { return origin + t * direction; }
};

struct Clip {
    bool hit = false;
    double entry = 0.0;
    double exit = 0.0;
};

Clip clip(const Beam& beam, const Ray& ray) {
    Clip result;
    const double sine = std::sin(beam.halfAngle);
    const double cosine = std::cos(beam.halfAngle);
    result.hit =
        beam.shape == Shape::kCone
            ? shader::clipToCone(ray.origin, ray.direction, cosine * cosine, sine * sine, kLens,
                                 beam.zFar, ray.t0, ray.t1, result.entry, result.exit)
            : shader::clipToPyramid(ray.origin, ray.direction, sine / cosine, kLens, beam.zFar,
                                    ray.t0, ray.t1, result.entry, result.exit);
    return result;
}

Clip clipInFloat(const Beam& beam, const Ray& ray) {
    const double sine = std::sin(beam.halfAngle);
    const double cosine = std::cos(beam.halfAngle);
    float entry = 0.0F;
    float exit = 0.0F;
    const glm::vec3 origin(ray.origin);
    const glm::vec3 direction(ray.direction);
    const bool hit =
        beam.shape == Shape::kCone
            ? shader_float::clipToCone(origin, direction, float(cosine * cosine),
                                       float(sine * sine), float(kLens), float(beam.zFar),
                                       float(ray.t0), float(ray.t1), entry, exit)
            : shader_float::clipToPyramid(origin, direction, float(sine / cosine), float(kLens),
                                          float(beam.zFar), float(ray.t0), float(ray.t1), entry,
                                          exit);
    return {hit, double(entry), double(exit)};
}

/// The clip against the beam's definition at many points of the ray.
void expectAgreesWithDefinition(const Beam& beam, const Ray& ray) {
    const Clip result = clip(beam, ray);
    const double tolerance = 1e-9 * (1.0 + glm::length(ray.origin) + ray.t1);
    const auto describe = [&] {
        std::ostringstream text;
        text.precision(17);
        text << "half angle " << beam.halfAngle / kRadian << " degrees, origin " << ray.origin.x
             << " " << ray.origin.y << " " << ray.origin.z << ", direction " << ray.direction.x
             << " " << ray.direction.y << " " << ray.direction.z << ", clip " << result.hit << " "
             << result.entry << ".." << result.exit;
        return text.str();
    };
    if (result.hit) {
        ASSERT_TRUE(result.entry >= ray.t0 && result.entry < result.exit && result.exit <= ray.t1)
            << describe();
        ASSERT_TRUE(result.entry == ray.t0 ||
                    std::abs(beam.depthInside(ray.at(result.entry))) < tolerance)
            << describe();
        ASSERT_TRUE(result.exit == ray.t1 ||
                    std::abs(beam.depthInside(ray.at(result.exit))) < tolerance)
            << describe();
    } else {
        ASSERT_EQ(result.entry, ray.t0);
        ASSERT_EQ(result.exit, ray.t0);
    }
    // Half of the points over the whole ray, half around where it is nearest to the axis.
    const double planar = glm::dot(glm::dvec2(ray.direction), glm::dvec2(ray.direction));
    const double nearest =
        planar > 0.0 ? -glm::dot(glm::dvec2(ray.origin), glm::dvec2(ray.direction)) / planar : 0.0;
    const double reach = 2.0 * std::abs(ray.at(nearest).z) * std::tan(beam.halfAngle) + 0.01;
    for (int i = 0; i < 200; ++i) {
        const double x = (i / 2 + 0.5) / 100.0;
        const double t =
            i % 2 == 0 ? ray.t0 + (ray.t1 - ray.t0) * x : nearest + reach * (2.0 * x - 1.0);
        if (t < ray.t0 || t > ray.t1) {
            continue;
        }
        const double depth = beam.depthInside(ray.at(t));
        const bool inside = result.hit && t >= result.entry && t <= result.exit;
        ASSERT_TRUE(std::abs(depth) < tolerance || (depth > 0.0) == inside)
            << "at " << t << ": depth " << depth << "; " << describe();
    }
}

class Rays {
  public:
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    glm::dvec3 direction() {
        const double z = uniform(-1.0, 1.0);
        const double azimuth = uniform(0.0, 2.0 * std::numbers::pi);
        const double sine = std::sqrt(1.0 - z * z);
        return {sine * std::cos(azimuth), sine * std::sin(azimuth), z};
    }
    double halfAngle() { return kRadian * std::exp(uniform(std::log(0.5), std::log(80.0))); }
    /// A point in or a little beside the beam.
    glm::dvec3 nearBeam(double halfAngle, double zMax) {
        const double z = uniform(0.0, zMax);
        const double width = 1.3 * z * std::tan(halfAngle);
        return {uniform(-width, width), uniform(-width, width), z};
    }
    /// Looks from `distance` metres away at something in or beside the beam.
    Ray towards(double halfAngle, double zMax, double distance) {
        const glm::dvec3 target = nearBeam(halfAngle, zMax);
        Ray ray;
        ray.direction = direction();
        ray.origin = target - distance * ray.direction;
        ray.t1 = uniform(0.2, 2.0) * distance + 10.0;
        return ray;
    }

  private:
    std::mt19937_64 random_{20240607};
};

class BeamClip : public ::testing::TestWithParam<Shape> {};

TEST_P(BeamClip, AgreesWithTheDefinitionOnRandomRays) {
    Rays rays;
    for (int i = 0; i < 30000; ++i) {
        const Beam beam{GetParam(), rays.halfAngle(), i % 3 == 0 ? rays.uniform(1.0, 30.0) : 1e30};
        const double distance = i % 2 == 0 ? rays.uniform(0.0, 30.0) : rays.uniform(30.0, 500.0);
        ASSERT_NO_FATAL_FAILURE(
            expectAgreesWithDefinition(beam, rays.towards(beam.halfAngle, 30.0, distance)));
    }
}

TEST_P(BeamClip, AgreesWhereTheCameraIsInTheBeam) {
    Rays rays;
    for (int i = 0; i < 20000; ++i) {
        const Beam beam{GetParam(), rays.halfAngle()};
        Ray ray;
        const double z = rays.uniform(0.0, 20.0);
        const double width = 0.7 * z * std::tan(beam.halfAngle);
        ray.origin = {rays.uniform(-width, width), rays.uniform(-width, width), z};
        ray.direction = rays.direction();
        ASSERT_NO_FATAL_FAILURE(expectAgreesWithDefinition(beam, ray));
    }
}

TEST_P(BeamClip, AgreesAtTheLampAlongTheAxisAndAlongTheEdge) {
    Rays rays;
    for (int i = 0; i < 20000; ++i) {
        const Beam beam{GetParam(), rays.halfAngle()};
        const double sine = std::sin(beam.halfAngle);
        const double cosine = std::cos(beam.halfAngle);
        const double azimuth = rays.uniform(0.0, 2.0 * std::numbers::pi);
        Ray ray;
        switch (i % 4) {
            case 0:  // from the lamp itself
                ray.direction = rays.direction();
                break;
            case 1:  // parallel to the axis, both ways
                ray.origin = {rays.uniform(-2.0, 2.0), rays.uniform(-2.0, 2.0),
                              rays.uniform(-20.0, 20.0)};
                ray.direction = {0.0, 0.0, i % 8 < 4 ? 1.0 : -1.0};
                break;
            case 2:  // parallel to the edge, both ways, beside it by up to 2 m
                ray.direction = {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
                ray.direction *= i % 8 < 4 ? 1.0 : -1.0;
                ray.origin = {rays.uniform(-2.0, 2.0), rays.uniform(-2.0, 2.0),
                              rays.uniform(-20.0, 20.0)};
                break;
            default:  // at right angles to the axis
                ray.origin = {-20.0 * std::cos(azimuth), -20.0 * std::sin(azimuth),
                              rays.uniform(-1.0, 10.0)};
                ray.direction = {std::cos(azimuth), std::sin(azimuth), 0.0};
        }
        ASSERT_NO_FATAL_FAILURE(expectAgreesWithDefinition(beam, ray));
    }
}

TEST_P(BeamClip, KnowsTheSimpleCases) {
    const Beam beam{GetParam(), 45.0 * kRadian, 10.0};
    // Across the beam 2 m before the lamp.
    Clip result = clip(beam, {{-5.0, 0.0, 2.0}, {1.0, 0.0, 0.0}});
    EXPECT_TRUE(result.hit);
    EXPECT_NEAR(result.entry, 3.0, 1e-12);
    EXPECT_NEAR(result.exit, 7.0, 1e-12);
    // Into the lamp along the axis, and away from it.
    result = clip(beam, {{0.0, 0.0, 12.0}, {0.0, 0.0, -1.0}});
    EXPECT_TRUE(result.hit);
    EXPECT_NEAR(result.entry, 2.0, 1e-12);
    EXPECT_NEAR(result.exit, 12.0 - kLens, 1e-12);
    result = clip(beam, {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}});
    EXPECT_TRUE(result.hit);
    EXPECT_NEAR(result.entry, kLens, 1e-12);
    EXPECT_NEAR(result.exit, 10.0, 1e-12);
    // Behind the lamp, past the far plane, away from the beam, behind the surface.
    EXPECT_FALSE(clip(beam, {{-5.0, 0.0, -2.0}, {1.0, 0.0, 0.0}}).hit);
    EXPECT_FALSE(clip(beam, {{-5.0, 0.0, 11.0}, {1.0, 0.0, 0.0}}).hit);
    EXPECT_FALSE(clip(beam, {{-5.0, 0.0, 2.0}, {-1.0, 0.0, 0.0}}).hit);
    EXPECT_FALSE(clip(beam, {{-5.0, 0.0, 2.0}, {1.0, 0.0, 0.0}, 0.0, 2.9}).hit);
    EXPECT_FALSE(clip(beam, {{-5.0, 0.0, 2.0}, {1.0, 0.0, 0.0}, 7.1, 9.0}).hit);
}

INSTANTIATE_TEST_SUITE_P(Shapes, BeamClip, ::testing::Values(Shape::kCone, Shape::kPyramid),
                         [](const auto& shape) {
                             return shape.param == Shape::kCone ? "Cone" : "Pyramid";
                         });

/// Per cent of rays whose float ends are more than a centimetre from the double ones.
double percentOffInFloat(Shape shape, double degrees, double distance) {
    Rays rays;
    const Beam beam{shape, degrees * kRadian};
    constexpr int kRays = 200000;
    int off = 0;
    for (int i = 0; i < kRays; ++i) {
        Ray ray = rays.towards(beam.halfAngle, 20.0, distance);
        // Both precisions get the same numbers.
        ray.origin = glm::dvec3(glm::vec3(ray.origin));
        ray.direction = glm::dvec3(glm::vec3(ray.direction));
        ray.t1 = double(float(ray.t1));
        const Clip exact = clip(beam, ray);
        const Clip rounded = clipInFloat(beam, ray);
        const double error = exact.hit && rounded.hit
                                 ? std::max(std::abs(exact.entry - rounded.entry),
                                            std::abs(exact.exit - rounded.exit))
                                 : std::max(exact.exit - exact.entry, rounded.exit - rounded.entry);
        off += error < 0.01 ? 0 : 1;
    }
    return 100.0 * off / kRays;
}

TEST(BeamClipInFloat, StaysWithinACentimetre) {
    EXPECT_LT(percentOffInFloat(Shape::kCone, 0.5, 50.0), 0.001);
    EXPECT_LT(percentOffInFloat(Shape::kCone, 10.0, 50.0), 0.001);
    EXPECT_LT(percentOffInFloat(Shape::kCone, 10.0, 500.0), 0.002);
    EXPECT_LT(percentOffInFloat(Shape::kCone, 80.0, 50.0), 0.001);
    EXPECT_LT(percentOffInFloat(Shape::kPyramid, 0.5, 50.0), 0.001);
    EXPECT_LT(percentOffInFloat(Shape::kPyramid, 10.0, 500.0), 0.002);
}

TEST(BeamClipInFloat, IsNeverNaNNorOutOfOrder) {
    Rays rays;
    const double values[] = {0.0, -0.0, 1e-30, 1e-7, -1e-7, 0.05, 1.0, -1.0, 1e4, -1e6};
    const int count = int(std::size(values));
    for (int i = 0; i < 200000; ++i) {
        const auto pick = [&] { return values[int(rays.uniform(0.0, count - 1e-9))]; };
        Ray ray;
        ray.origin = {pick(), pick(), pick()};
        ray.direction = {pick(), pick(), pick()};
        if (glm::length(ray.direction) == 0.0) {
            continue;
        }
        ray.direction = glm::normalize(ray.direction);
        for (const Shape shape : {Shape::kCone, Shape::kPyramid}) {
            const Beam beam{shape, rays.halfAngle()};
            const Clip result = clipInFloat(beam, ray);
            ASSERT_TRUE(result.entry >= 0.0 && result.exit <= 100.0 &&
                        (result.hit ? result.entry < result.exit : result.entry == result.exit));
        }
    }
}

TEST(ProjectivePlacement, RunsFromEndToEndWithItsDerivative) {
    for (const double z0 : {0.05, 1.0, 300.0}) {
        for (const double z1 : {0.05, 2.0, 1000.0}) {
            EXPECT_EQ(shader::projectiveStep(0.0, z0, z1), 0.0);
            EXPECT_NEAR(shader::projectiveStep(1.0, z0, z1), 1.0, 1e-15);
            for (double x = 0.05; x < 1.0; x += 0.1) {
                const double step = 1e-6;
                const double slope = (shader::projectiveStep(x + step, z0, z1) -
                                      shader::projectiveStep(x - step, z0, z1)) /
                                     (2.0 * step);
                const double weight = shader::projectiveWeight(x, z0, z1);
                EXPECT_NEAR(weight, slope, 1e-6 * slope + 1e-9);
            }
        }
    }
}

TEST(ProjectivePlacement, MakesInverseDepthAndSlopesLinear) {
    const glm::dvec3 a(0.3, -0.2, 1.5);
    const glm::dvec3 b(-1.0, 2.0, 9.0);
    for (double x = 0.0; x <= 1.0; x += 0.125) {
        const glm::dvec3 p = glm::mix(a, b, shader::projectiveStep(x, a.z, b.z));
        EXPECT_NEAR(1.0 / p.z, glm::mix(1.0 / a.z, 1.0 / b.z, x), 1e-14);
        EXPECT_NEAR(p.x / p.z, glm::mix(a.x / a.z, b.x / b.z, x), 1e-14);
        EXPECT_NEAR(p.y / p.z, glm::mix(a.y / a.z, b.y / b.z, x), 1e-14);
    }
}

TEST(ProjectivePlacement, WeightOverSquareIsWeightOverTheSquare) {
    const glm::dvec3 a(0.3, -0.2, 1.5);
    const glm::dvec3 b(-1.0, 2.0, 9.0);
    const double length = glm::length(b - a);
    for (double x = 0.0; x <= 1.0; x += 0.125) {
        const glm::dvec3 p = glm::mix(a, b, shader::projectiveStep(x, a.z, b.z));
        const double expected = length * shader::projectiveWeight(x, a.z, b.z) / glm::dot(p, p);
        const glm::dvec2 slope(p.x / p.z, p.y / p.z);
        EXPECT_NEAR(shader::projectiveWeightOverSquare(length, a.z, b.z, slope), expected,
                    1e-13 * expected);
    }
}

TEST(ProjectivePlacement, StaysFiniteInFloat) {
    const float depths[] = {0.05F, 1.0F, 1e4F, 1e9F, 1e30F};
    for (const float z0 : depths) {
        for (const float z1 : depths) {
            for (const float x : {0.0F, 1e-6F, 0.5F, 1.0F}) {
                const float step = shader_float::projectiveStep(x, z0, z1);
                EXPECT_TRUE(step >= 0.0F && step <= 1.000001F) << z0 << ", " << z1 << ", " << x;
                EXPECT_TRUE(std::isfinite(shader_float::projectiveWeight(x, z0, z1)));
            }
        }
    }
}

}  // namespace
}  // namespace ribalta
