// The reference integral against closed forms, and against a plain sum of the beam's definition
// written out in world coordinates with angles.
#include "reference/integrate_beams.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "reference/closed_forms.h"
#include "reference/light_map_texture.h"

namespace ribalta {
namespace {

/// A lamp at the origin that shines along -Z evenly in all of its square beam.
SpotLight evenLamp() {
    SpotLight lamp;
    lamp.beamShape = BeamShape::kPyramid;
    lamp.outerConeAngle = 0.25 * kPi;
    lamp.innerConeAngle = 0.0;
    lamp.intensityCandela = 1000.0;
    lamp.color = {1.0F, 0.5F, 0.25F};
    return lamp;
}

/// A lamp that stands askew, with everything a cone can have but a light map.
SpotLight coneLamp() {
    SpotLight lamp;
    lamp.frame = lookAt({1.0, 6.0, -2.0}, {0.3, 0.0, 1.0});
    lamp.innerConeAngle = 0.12;
    lamp.outerConeAngle = 0.3;
    lamp.intensityCandela = 20000.0;
    lamp.color = {1.0F, 0.75F, 0.25F};
    lamp.rangeMetres = 9.0;
    return lamp;
}

Haze makeHaze(double scattering, double absorption, PhaseFunction::Kind kind, double g = 0.0) {
    Haze haze;
    haze.scatteringPerMetre = scattering;
    haze.absorptionPerMetre = absorption;
    haze.phase.kind = kind;
    haze.phase.g = g;
    return haze;
}

/// A ray that crosses the even lamp's beam at depth z, `height` above the axis: it is inside for
/// |x| <= z, starts at x = -20 and runs along +X.
BeamRay across(double z, double height, double last = 40.0) {
    return {{-20.0, height, -z}, {1.0, 0.0, 0.0}, 0.0, last};
}

BeamLight integrate(const SpotLight& lamp, const Haze& haze, const BeamRay& ray,
                    const LampVisibility& isVisible = nullptr, double relativeError = 1e-6,
                    std::span<const Image> images = {}) {
    auto visibility = isVisible ? std::make_unique<ProbedVisibility>(isVisible) : nullptr;
    return BeamIntegrator({&lamp, 1}, images, haze, std::move(visibility), relativeError)
        .along(ray);
}

TEST(IntegrateBeams, AgreesWithSunAcrossTheBeam) {
    for (const double extinction : {0.05, 0.3, 0.9}) {
        const Haze haze = makeHaze(0.05, extinction - 0.05, PhaseFunction::Kind::kIsotropic);
        for (const double z : {0.1, 1.0, 8.0}) {
            for (const double height : {0.0, 0.5}) {
                if (height >= z) {
                    continue;
                }
                const double h = std::hypot(z, height);
                const double exact =
                    1000.0 * isotropicPointSource(h, 20.0, -z, z, 0.05, extinction);
                const BeamLight result = integrate(evenLamp(), haze, across(z, height));
                EXPECT_NEAR(result.value.x, exact, 1e-6 * exact) << "z " << z;
                EXPECT_NEAR(result.value.y, 0.5 * exact, 1e-6 * exact);
                EXPECT_NEAR(result.value.z, 0.25 * exact, 1e-6 * exact);
                EXPECT_LE(std::abs(result.value.x - exact), result.error + 1e-12 * exact);
            }
        }
    }
}

TEST(IntegrateBeams, AgreesWithSunFromInsideTheBeam) {
    const Haze haze = makeHaze(0.04, 0.06, PhaseFunction::Kind::kIsotropic);
    const glm::dvec3 eyes[] = {{0.5, 0.2, -3.0}, {0.0, 0.1, -0.3}, {-2.0, 1.0, -10.0}};
    const glm::dvec3 targets[] = {{0.0, 0.3, -6.0}, {0.02, 0.0, -0.2}, {30.0, 20.0, -200.0}};
    for (const glm::dvec3& eye : eyes) {
        for (const glm::dvec3& target : targets) {
            // Eye and target are both inside, and so is all between.
            const double length = glm::length(target - eye);
            const glm::dvec3 direction = (target - eye) / length;
            const double nearest = -glm::dot(eye, direction);
            const double h = glm::length(glm::cross(eye, direction));
            const double exact =
                1000.0 * isotropicPointSource(h, nearest, -nearest, length - nearest, 0.04, 0.1);
            const BeamLight result = integrate(evenLamp(), haze, {eye, direction, 0.0, length});
            EXPECT_NEAR(result.value.x, exact, 1e-6 * exact) << "h " << h;
        }
    }
}

TEST(IntegrateBeams, AgreesWithGibbonsOverASlab) {
    // As good as no extinction: 1e-9 over 50 m.
    const double scattering = 2e-11;
    const Haze haze = makeHaze(scattering, 0.0, PhaseFunction::Kind::kGibbons);
    for (const double z : {0.1, 1.0, 8.0}) {
        const double exact = 1000.0 * scattering * gibbonsOverSlab(z, -z, z, 1.0 / (8.0 * kPi));
        EXPECT_NEAR(integrate(evenLamp(), haze, across(z, 0.0)).value.x, exact, 1e-6 * exact);
        const double upToTheAxis =
            1000.0 * scattering * gibbonsOverSlab(z, -z, 0.0, 1.0 / (8.0 * kPi));
        EXPECT_NEAR(integrate(evenLamp(), haze, across(z, 0.0, 20.0)).value.x, upToTheAxis,
                    1e-6 * upToTheAxis);
    }
}

TEST(IntegrateBeams, BeginsAtTheLensPlane) {
    // From the lamp along its axis, isotropic: 1 / (4 pi) times 1 / lens - 1 / last.
    const Haze haze = makeHaze(1e-12, 0.0, PhaseFunction::Kind::kIsotropic);
    const double exact = 1000.0 * 1e-12 / (4.0 * kPi) * (1.0 / 0.05 - 1.0 / 10.0);
    const BeamRay away{{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 0.0, 10.0};
    EXPECT_NEAR(integrate(evenLamp(), haze, away).value.x, exact, 1e-6 * exact);
    const BeamRay into{{0.0, 0.0, -10.0}, {0.0, 0.0, 1.0}, 0.0, 30.0};
    EXPECT_NEAR(integrate(evenLamp(), haze, into).value.x, exact, 1e-6 * exact);
    const BeamRay endless{
        {0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 0.0, std::numeric_limits<double>::infinity()};
    const double all = 1000.0 * 1e-12 / (4.0 * kPi) / 0.05;
    EXPECT_NEAR(integrate(evenLamp(), haze, endless).value.x, all, 1e-6 * all);
}

TEST(IntegrateBeams, AHalfHiddenSlabIsTheClosedFormOfTheOtherHalf) {
    const Haze haze = makeHaze(0.05, 0.1, PhaseFunction::Kind::kIsotropic);
    const LampVisibility wall = [](const SpotLight&, const glm::dvec3& p) { return p.x < 0.37; };
    for (const double z : {1.0, 8.0}) {
        const double exact = 1000.0 * isotropicPointSource(z, 20.0, -z, 0.37, 0.05, 0.15);
        const BeamLight result = integrate(evenLamp(), haze, across(z, 0.0), wall);
        EXPECT_NEAR(result.value.x, exact, 1e-6 * exact) << "z " << z;
    }
    const LampVisibility slats = [](const SpotLight&, const glm::dvec3& p) {
        return int(std::floor(p.x + 50.0)) % 2 == 0;
    };
    double exact = 0.0;
    for (int x = -8; x < 8; x += 2) {
        exact += 1000.0 * isotropicPointSource(8.0, 20.0, x, x + 1, 0.05, 0.15);
    }
    EXPECT_NEAR(integrate(evenLamp(), haze, across(8.0, 0.0), slats).value.x, exact, 1e-6 * exact);
}

TEST(IntegrateBeams, AHiddenLampGivesNothing) {
    const Haze haze = makeHaze(0.05, 0.1, PhaseFunction::Kind::kIsotropic);
    const LampVisibility never = [](const SpotLight&, const glm::dvec3&) { return false; };
    EXPECT_EQ(integrate(evenLamp(), haze, across(2.0, 0.0), never).value, glm::dvec3(0.0));
    EXPECT_EQ(integrate(evenLamp(), haze, across(-2.0, 0.0)).value, glm::dvec3(0.0));
    EXPECT_EQ(integrate(evenLamp(), haze, across(2.0, 0.0, 10.0)).value, glm::dvec3(0.0));
}

/// The definition of a beam, summed: angles by acos, no clip, no placement, its own formulas.
glm::dvec3 sumByDefinition(const SpotLight& lamp, const Haze& haze, const BeamRay& ray,
                           const LightMapTexture* map, const LampVisibility& isVisible) {
    constexpr int kSteps = 400000;
    const double step = (ray.last - ray.first) / kSteps;
    glm::dvec3 total(0.0);
    for (int i = 0; i < kSteps; ++i) {
        const double t = ray.first + step * (i + 0.5);
        const glm::dvec3 point = ray.origin + t * ray.direction;
        const glm::dvec3 local =
            glm::transpose(lamp.frame.worldFromLocal) * (point - lamp.frame.position);
        const double r = glm::length(local);
        const double angle = std::acos(-local.z / r);
        if (angle >= lamp.outerConeAngle || -local.z < 0.05 || r >= lamp.rangeMetres ||
            (isVisible && !isVisible(lamp, point))) {
            continue;
        }
        const double ramp = (std::cos(angle) - std::cos(lamp.outerConeAngle)) /
                            (std::cos(lamp.innerConeAngle) - std::cos(lamp.outerConeAngle));
        const double falloff = ramp > 1.0 ? 1.0 : ramp * ramp;
        const double window = 1.0 - std::pow(r / lamp.rangeMetres, 4.0);
        const double mu =
            -glm::dot(local, glm::transpose(lamp.frame.worldFromLocal) * ray.direction) / r;
        const double g = haze.phase.g;
        const double phase =
            (1.0 - g * g) / (4.0 * kPi * std::pow(1.0 + g * g - 2.0 * g * mu, 1.5));
        glm::dvec3 light = glm::dvec3(lamp.color) * lamp.intensityCandela * falloff * window;
        if (map != nullptr) {
            const double turn = lamp.lightMap->rotationRadians;
            const double azimuth = std::atan2(local.y, local.x) - turn;
            const double radius = 0.5 * std::tan(angle) / std::tan(lamp.outerConeAngle);
            light *= map->at({0.5 + radius * std::cos(azimuth), 0.5 - radius * std::sin(azimuth)});
        }
        total += light * (phase * haze.scatteringPerMetre *
                          std::exp(-haze.extinctionPerMetre() * (r + t)) / (r * r) * step);
    }
    return total;
}

void expectClose(const glm::dvec3& value, const glm::dvec3& expected, double relative) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(value[c], expected[c], relative * expected[c]) << "channel " << c;
    }
}

const BeamRay kConeRays[] = {
    // From the side, from behind the lamp, from in the beam away from and into the lamp.
    {{-9.0, 2.0, 3.0}, glm::normalize(glm::dvec3(9.5, 0.7, -3.0)), 0.1, 30.0},
    {{1.2, 8.0, -2.6}, glm::normalize(glm::dvec3(-0.65, -6.0, 2.8)), 0.1, 12.0},
    {{0.9, 5.0, -1.5}, glm::normalize(glm::dvec3(-0.4, -5.0, 2.2)), 0.1, 5.0},
    {{0.5, 1.0, 0.6}, glm::normalize(glm::dvec3(0.5, 5.0, -2.4)), 0.1, 20.0},
};

TEST(IntegrateBeams, AgreesWithTheDefinitionOfACone) {
    const Haze haze = makeHaze(0.08, 0.02, PhaseFunction::Kind::kHenyeyGreenstein, 0.6);
    const LampVisibility sphere = [](const SpotLight& lamp, const glm::dvec3& p) {
        // Whether a ball of 0.25 m stands between lamp and point.
        const glm::dvec3 centre(0.85, 4.5, -1.2);
        const glm::dvec3 way = p - lamp.frame.position;
        const double along =
            glm::clamp(glm::dot(centre - lamp.frame.position, way) / glm::dot(way, way), 0.0, 1.0);
        return glm::length(lamp.frame.position + along * way - centre) > 0.25;
    };
    for (const BeamRay& ray : kConeRays) {
        const glm::dvec3 open = sumByDefinition(coneLamp(), haze, ray, nullptr, nullptr);
        ASSERT_GT(open.x, 1.0);
        expectClose(integrate(coneLamp(), haze, ray).value, open, 2e-5);
        const glm::dvec3 shadowed = sumByDefinition(coneLamp(), haze, ray, nullptr, sphere);
        ASSERT_LT(shadowed.x, 0.99 * open.x);
        expectClose(integrate(coneLamp(), haze, ray, sphere).value, shadowed, 1e-4);
    }
}

/// 16 x 16 texels in a pattern without symmetry.
Image makePattern() {
    Image image;
    image.width = 16;
    image.height = 16;
    image.pixels = RawBytes(16 * 16 * 4);
    std::byte* to = image.pixels.data();
    for (int i = 0; i < 16 * 16; ++i) {
        const int x = i % 16;
        const int y = i / 16;
        for (const int channel : {40 + 13 * x, 255 - 11 * y, (37 * x + 91 * y) % 256, 255}) {
            *to++ = std::byte(channel);
        }
    }
    return image;
}

TEST(IntegrateBeams, AgreesWithTheDefinitionOfALightMap) {
    const Haze haze = makeHaze(0.08, 0.02, PhaseFunction::Kind::kHenyeyGreenstein, -0.3);
    const Image image = makePattern();
    const LightMapTexture map(image);
    for (const double rotation : {0.0, 0.7}) {
        SpotLight lamp = coneLamp();
        lamp.lightMap = LightMap{0, rotation};
        for (const BeamRay& ray : kConeRays) {
            const glm::dvec3 expected = sumByDefinition(lamp, haze, ray, &map, nullptr);
            expectClose(integrate(lamp, haze, ray, nullptr, 1e-6, {&image, 1}).value, expected,
                        2e-5);
        }
    }
}

TEST(IntegrateBeams, ItsErrorEstimateIsHonest) {
    const Haze haze = makeHaze(0.08, 0.02, PhaseFunction::Kind::kCornetteShanks, 0.7);
    const Image image = makePattern();
    SpotLight lamp = coneLamp();
    lamp.lightMap = LightMap{0, 0.3};
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> offset(-1.0, 1.0);
    for (int i = 0; i < 400; ++i) {
        BeamRay ray = kConeRays[i % 4];
        const glm::dvec3 aside(offset(random), offset(random), offset(random));
        ray.direction = glm::normalize(ray.direction + 0.15 * aside);
        const auto with = [&](double relative) {
            return integrate(lamp, haze, ray, nullptr, relative, {&image, 1});
        };
        const BeamLight finest = with(1e-11);
        const double largest = std::max({finest.value.x, finest.value.y, finest.value.z});
        for (const double relative : {1e-2, 1e-4, 1e-6, 1e-8}) {
            const BeamLight result = with(relative);
            EXPECT_LE(result.error, 1.1 * relative * largest) << "ray " << i;
            for (int c = 0; c < 3; ++c) {
                EXPECT_LE(std::abs(result.value[c] - finest.value[c]),
                          result.error + 1e-11 * largest)
                    << "ray " << i;
            }
        }
    }
}

TEST(IntegrateBeams, LampsAddUp) {
    const Haze haze = makeHaze(0.08, 0.02, PhaseFunction::Kind::kRayleigh);
    const SpotLight lamps[] = {coneLamp(), evenLamp()};
    const BeamRay ray = kConeRays[0];
    const BeamLight both = BeamIntegrator(lamps, {}, haze, nullptr).along(ray);
    const BeamLight first = integrate(lamps[0], haze, ray);
    const BeamLight second = integrate(lamps[1], haze, ray);
    expectClose(both.value, first.value + second.value, 1e-14);
    EXPECT_EQ(both.evaluations, first.evaluations + second.evaluations);
}

}  // namespace
}  // namespace ribalta
