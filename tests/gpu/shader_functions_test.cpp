// The shader library as the GPU computes it against the same text in double precision, on 20,000
// random inputs a function. Inputs are singles, so that both sides see the very same numbers.
#include "shader_functions.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "evaluate_glsl.h"
#include "gpu_test.h"

namespace ribalta::test {
namespace {

constexpr int kCases = 20000;

class Random {
  public:
    float between(double low, double high) {
        return float(std::uniform_real_distribution<double>(low, high)(engine_));
    }
    /// Even over the orders of magnitude.
    float magnitude(double low, double high) {
        return float(low * std::pow(high / low, double(between(0.0, 1.0))));
    }
    glm::vec3 direction() {
        glm::vec3 v;
        do {
            const float x = between(-1, 1);
            const float y = between(-1, 1);
            v = glm::vec3(x, y, between(-1, 1));
        } while (glm::length(v) > 1.0F || glm::length(v) < 0.1F);
        return glm::normalize(v);
    }

  private:
    std::mt19937 engine_{7};
};

using Inputs = std::vector<float>;
using Doubles = std::vector<double>;

/// How far the GPU may be off: absolute + relative |exact|.
struct Bound {
    double relative = 0.0;
    double absolute = 0.0;
};

class ShaderFunctions : public GpuTest {
  protected:
    /// Compares `glsl` with `exact` on inputs that `draw` makes.
    void compare(const std::string& glsl, int outputs, const std::function<Inputs(Random&)>& draw,
                 const std::function<Doubles(const Doubles&)>& exact, const Bound& bound) {
        Random random;
        std::vector<float> values;
        int inputs = 0;
        for (int i = 0; i < kCases; ++i) {
            const Inputs one = draw(random);
            inputs = int(one.size());
            values.insert(values.end(), one.begin(), one.end());
        }
        const std::vector<float> results = evaluateGlsl(glsl, values, inputs, outputs);
        double worst = 0.0;
        std::string where;
        for (int i = 0; i < kCases; ++i) {
            const Doubles one(values.begin() + std::ptrdiff_t(i) * inputs,
                              values.begin() + std::ptrdiff_t(i + 1) * inputs);
            const Doubles right = exact(one);
            for (int o = 0; o < outputs; ++o) {
                const double off = std::abs(
                    double(results[std::size_t(i) * std::size_t(outputs) + std::size_t(o)]) -
                    right[std::size_t(o)]);
                const double share =
                    off / (bound.absolute + bound.relative * std::abs(right[std::size_t(o)]));
                // NaN must count as off.
                if (!(share <= worst)) {
                    worst = std::isnan(share) ? INFINITY : share;
                    std::ostringstream text;
                    text << "output " << o << ": "
                         << results[std::size_t(i) * std::size_t(outputs) + std::size_t(o)]
                         << " for " << right[std::size_t(o)] << " at";
                    for (const double value : one) {
                        text << ' ' << value;
                    }
                    where = text.str();
                }
            }
        }
        EXPECT_LE(worst, 1.0) << glsl << ": " << where;
    }
};

TEST_F(ShaderFunctions, PhaseFunctions) {
    const auto draw = [](Random& r) {
        return Inputs{r.between(-1, 1), r.between(-0.95, 0.95), r.magnitude(0.01, 30.0)};
    };
    for (int kind = shader::kPhaseGibbons; kind <= shader::kPhaseRayleigh; ++kind) {
        // At the sharpest g the peak's denominator, 0.0025, holds (1 - g)^2 and 1 - mu, each exact
        // to 6e-8 of 1: up to 1.5 * 6e-8 * 2 / 0.0025 of the value.
        compare(
            "put(0, phaseFunction(" + std::to_string(kind) + ", a(0), a(1), a(2)));", 1, draw,
            [&](const Doubles& a) {
                return Doubles{shader::phaseFunction(kind, a[0], a[1], a[2])};
            },
            {kind == shader::kPhaseHenyeyGreenstein || kind == shader::kPhaseCornetteShanks ? 7e-5
                                                                                            : 2e-6,
             0.0});
    }
}

TEST_F(ShaderFunctions, SpotLight) {
    // The difference of two cosines near 1 keeps 6e-8 absolute; the ramp's slope is at most 1000.
    compare(
        "put(0, coneFalloff(a(0), a(1), a(2)));", 1,
        [](Random& r) {
            const float outer = r.between(0.01, 1.4);
            const float inner = r.between(0.0, double(outer));
            return Inputs{std::cos(r.between(0.0, 1.2 * double(outer))), std::cos(inner),
                          std::cos(outer)};
        },
        [](const Doubles& a) { return Doubles{shader::coneFalloff(a[0], a[1], a[2])}; },
        {0.0, 1.5e-4});
    // 1 - ratio^4 near the range's end keeps the rounding of ratio, four times.
    compare(
        "put(0, rangeWindow(a(0), a(1)));", 1,
        [](Random& r) {
            return Inputs{r.magnitude(0.01, 100.0),
                          r.between(0, 1) < 0.1F ? 0.0F : r.magnitude(0.01, 1.0)};
        },
        [](const Doubles& a) { return Doubles{shader::rangeWindow(a[0], a[1])}; }, {0.0, 1e-6});
    compare(
        "put(0, inverseSquare(a(0)));", 1, [](Random& r) { return Inputs{r.magnitude(1e-3, 1e4)}; },
        [](const Doubles& a) { return Doubles{shader::inverseSquare(a[0])}; }, {1e-6, 0.0});
    compare(
        "vec2 uv = lightMapUv(vec2(a(0), a(1)), a(2), a(3), a(4)); put(0, uv.x); put(1, uv.y);", 2,
        [](Random& r) {
            const auto angle = double(r.between(0.0, 2.0 * std::numbers::pi));
            const double tangent = std::tan(double(r.between(0.01, 1.4)));
            return Inputs{r.between(-tangent, tangent), r.between(-tangent, tangent),
                          float(1.0 / tangent), float(std::cos(angle)), float(std::sin(angle))};
        },
        [](const Doubles& a) {
            const glm::dvec2 uv = shader::lightMapUv({a[0], a[1]}, a[2], a[3], a[4]);
            return Doubles{uv.x, uv.y};
        },
        {0.0, 5e-7});
}

TEST_F(ShaderFunctions, Haze) {
    // exp of x is good to x roundings of x itself.
    compare(
        "put(0, transmittance(a(0), a(1)));", 1,
        [](Random& r) {
            return Inputs{r.magnitude(1e-4, 1.0), r.magnitude(1e-3, 20.0)};
        },
        [](const Doubles& a) { return Doubles{shader::transmittance(a[0], a[1])}; }, {5e-6, 0.0});
    // The library states 7e-6 just above its series' end.
    compare(
        "put(0, oneMinusExpOver(a(0)));", 1,
        [](Random& r) { return Inputs{r.magnitude(1e-8, 50.0)}; },
        [](const Doubles& a) { return Doubles{shader::oneMinusExpOver(a[0])}; }, {3e-5, 0.0});
    compare(
        "put(0, scatteredIntensity(a(0), a(1), a(2), a(3), a(4)));", 1,
        [](Random& r) {
            return Inputs{r.between(0.01, 3.0), r.magnitude(1e-3, 1.0), r.magnitude(1e-3, 1.0),
                          r.magnitude(0.01, 10.0), r.magnitude(0.01, 10.0)};
        },
        [](const Doubles& a) {
            return Doubles{shader::scatteredIntensity(a[0], a[1], a[2], a[3], a[4])};
        },
        {5e-6, 0.0});
    compare(
        "put(0, scatteringCosine(a3(0), a3(3)));", 1,
        [](Random& r) {
            const glm::vec3 p = r.magnitude(0.01, 100.0) * r.direction();
            const glm::vec3 d = r.direction();
            return Inputs{p.x, p.y, p.z, d.x, d.y, d.z};
        },
        [](const Doubles& a) {
            return Doubles{shader::scatteringCosine({a[0], a[1], a[2]}, {a[3], a[4], a[5]})};
        },
        {0.0, 5e-7});
}

/// Origin, direction, half angle's terms, lens, far, t0, t1: a ray from up to 20 m away that looks
/// at a random point near the beam.
Inputs drawRay(Random& r, double smallest, double largest) {
    const auto angle = double(r.magnitude(smallest, largest));
    const float depth = r.magnitude(0.1, 20.0);
    const double side = std::tan(angle) * double(depth);
    const float x = r.between(-1.2 * side, 1.2 * side);
    const glm::vec3 target(x, r.between(-1.2 * side, 1.2 * side), depth);
    const glm::vec3 origin = r.magnitude(0.01, 20.0) * r.direction();
    const glm::vec3 d = glm::normalize(target - origin);
    return {origin.x,
            origin.y,
            origin.z,
            d.x,
            d.y,
            d.z,
            float(std::cos(angle) * std::cos(angle)),
            float(std::sin(angle) * std::sin(angle)),
            float(std::tan(angle)),
            r.magnitude(5.0, 1e4),
            r.between(0.0, 0.5),
            r.magnitude(1.0, 100.0)};
}

TEST_F(ShaderFunctions, BeamsEnds) {
    // Where a ray only grazes, singles and doubles may disagree on whether it hits at all. What
    // counts is the length inside, and for a hit its ends: within 1 cm, which the library states
    // for all but one in a million rays.
    const char* const names[] = {"clipToCone", "clipToPyramid"};
    for (const bool pyramid : {false, true}) {
        Random random;
        std::vector<float> values;
        for (int i = 0; i < kCases; ++i) {
            const Inputs one = drawRay(random, 0.00873, 1.39);
            values.insert(values.end(), one.begin(), one.end());
        }
        const std::string call =
            pyramid ? "clipToPyramid(a3(0), a3(3), a(8)" : "clipToCone(a3(0), a3(3), a(6), a(7)";
        const std::vector<float> results =
            evaluateGlsl("float x; float y; bool hit = " + call +
                             ", kLensMetres, a(9), a(10), a(11), x, y);\n"
                             "put(0, hit ? 1.0 : 0.0); put(1, x); put(2, y);",
                         values, 12, 3);
        int hits = 0;
        int misses = 0;
        int off = 0;
        for (std::size_t i = 0; i < kCases; ++i) {
            const float* a = &values[12 * i];
            const glm::dvec3 origin(a[0], a[1], a[2]);
            const glm::dvec3 direction = glm::normalize(glm::dvec3(a[3], a[4], a[5]));
            double entry = 0.0;
            double exit = 0.0;
            const bool hit =
                pyramid
                    ? shader::clipToPyramid(origin, direction, double(a[8]), shader::kLensMetres,
                                            double(a[9]), double(a[10]), double(a[11]), entry, exit)
                    : shader::clipToCone(origin, direction, double(a[6]), double(a[7]),
                                         shader::kLensMetres, double(a[9]), double(a[10]),
                                         double(a[11]), entry, exit);
            const double length = hit ? exit - entry : 0.0;
            const bool drawnHit = results[3 * i] > 0.5F;
            const double drawnLength =
                drawnHit ? double(results[3 * i + 2]) - double(results[3 * i + 1]) : 0.0;
            const bool bad = !(std::abs(length - drawnLength) < 0.02) ||
                             (hit && drawnHit &&
                              !(std::abs(entry - double(results[3 * i + 1])) < 0.01 &&
                                std::abs(exit - double(results[3 * i + 2])) < 0.01));
            off += bad ? 1 : 0;
            ++(hit ? hits : misses);
        }
        EXPECT_GT(hits, kCases / 5) << names[pyramid ? 1 : 0];
        EXPECT_GT(misses, kCases / 20) << names[pyramid ? 1 : 0];
        EXPECT_LE(off, 0) << names[pyramid ? 1 : 0] << ", of " << kCases;
    }
}

TEST_F(ShaderFunctions, ProjectivePlacement) {
    const auto draw = [](Random& r) {
        return Inputs{r.between(0, 1),          r.magnitude(0.05, 1e3), r.magnitude(0.05, 1e3),
                      r.magnitude(0.01, 100.0), r.between(-5, 5),       r.between(-5, 5)};
    };
    compare(
        "put(0, projectiveStep(a(0), a(1), a(2))); put(1, projectiveWeight(a(0), a(1), a(2)));"
        "put(2, projectiveWeightOverSquare(a(3), a(1), a(2), vec2(a(4), a(5))));",
        3, draw,
        [](const Doubles& a) {
            return Doubles{shader::projectiveStep(a[0], a[1], a[2]),
                           shader::projectiveWeight(a[0], a[1], a[2]),
                           shader::projectiveWeightOverSquare(a[3], a[1], a[2], {a[4], a[5]})};
        },
        {2e-6, 0.0});
}

TEST_F(ShaderFunctions, Brdf) {
    // GGX's base is a sum of positive terms, squared; (1 - cos) near the peak is exact.
    compare(
        "put3(metallicRoughnessBrdf(a3(0), a(3), a(4), a(5), a(6), a(7), a(8)));", 3,
        [](Random& r) {
            Inputs in;
            for (int i = 0; i < 5; ++i) {
                in.push_back(r.between(0, 1));
            }
            in.push_back(r.between(-0.1, 1));
            in.push_back(r.between(-0.1, 1));
            in.push_back(r.between(0, 1));
            in.push_back(r.between(0, 1));
            return in;
        },
        [](const Doubles& a) {
            const glm::dvec3 f = shader::metallicRoughnessBrdf({a[0], a[1], a[2]}, a[3], a[4], a[5],
                                                               a[6], a[7], a[8]);
            return Doubles{f.x, f.y, f.z};
        },
        {2e-5, 1e-7});
}

TEST_F(ShaderFunctions, ToneMapping) {
    for (const Named<ToneCurve>& curve : toneCurves()) {
        // The curves of film take powers and logarithms, twice: still far below half of 1 / 255.
        const bool isFilm = curve.value == ToneCurve::kAgx || curve.value == ToneCurve::kAces;
        compare(
            "put3(tonemap(" + std::to_string(int(curve.value)) + ", a3(0)));", 3,
            [](Random& r) {
                return Inputs{r.magnitude(1e-4, 1e5), r.magnitude(1e-4, 1e5),
                              r.magnitude(1e-4, 1e5)};
            },
            [&](const Doubles& a) {
                const glm::dvec3 t = shader::tonemap(int(curve.value), {a[0], a[1], a[2]});
                return Doubles{t.x, t.y, t.z};
            },
            {0.0, isFilm ? 2e-5 : 2e-6});
    }
    // pow is a logarithm and an exponential: far better than the dither's half of 1 / 255.
    compare(
        "put3(srgbEncode(a3(0)));", 3,
        [](Random& r) {
            return Inputs{r.between(-0.1, 1.1), r.between(0, 0.01), r.between(0, 1)};
        },
        [](const Doubles& a) {
            const glm::dvec3 t = shader::srgbEncode({a[0], a[1], a[2]});
            return Doubles{t.x, t.y, t.z};
        },
        {0.0, 1e-5});
    compare(
        "put(0, exposureFromEv100(a(0)));", 1, [](Random& r) { return Inputs{r.between(-20, 30)}; },
        [](const Doubles& a) { return Doubles{shader::exposureFromEv100(a[0])}; }, {2e-5, 0.0});
}

TEST_F(ShaderFunctions, ViewRaysAndDepth) {
    compare(
        "vec4 h = vec4(a(2), a(3), a(4), 0.0); vec2 ndc = vec2(a(0), a(1));"
        "vec3 o = viewRayOrigin(ndc, h); vec3 d = viewRayDirection(ndc, h);"
        "put3(o); put(3, d.x); put(4, d.y); put(5, d.z);",
        6,
        [](Random& r) {
            return Inputs{r.between(-1, 1), r.between(-1, 1), r.between(0.05, 3),
                          r.between(0.05, 3), r.between(0, 1) < 0.5F ? 0.0F : 1.0F};
        },
        [](const Doubles& a) {
            const glm::dvec4 half(a[2], a[3], a[4], 0.0);
            const glm::dvec3 o = shader::viewRayOrigin({a[0], a[1]}, half);
            const glm::dvec3 d = shader::viewRayDirection({a[0], a[1]}, half);
            return Doubles{o.x, o.y, o.z, d.x, d.y, d.z};
        },
        {0.0, 5e-7});
    // Near and far planes as the renderer has them; depth from a distance between them.
    compare(
        "put(0, viewDistance(a(0), vec4(a(1), a(2), a(3), a(4)), a(5)));", 1,
        [](Random& r) {
            const auto n = double(r.magnitude(0.01, 1.0));
            const auto f = double(r.magnitude(10.0, 1000.0));
            const auto z = double(r.between(n, f));
            const auto kind = double(r.between(0, 3));
            if (kind < 1.0) {
                return Inputs{
                    float((f - z) / (f - n)), float(f), float(n - f), float(n), float(f), 1.0F};
            }
            if (kind < 2.0) {
                return Inputs{float(n / z), float(n), 0.0F, float(n), 1e30F, 0.0F};
            }
            return Inputs{float(n * (f - z) / (z * (f - n))),
                          float(n * f / (f - n)),
                          float(-n / (f - n)),
                          float(n),
                          float(f),
                          0.0F};
        },
        [](const Doubles& a) {
            return Doubles{shader::viewDistance(a[0], {a[1], a[2], a[3], a[4]}, a[5])};
        },
        {1e-6, 1e-4});
    compare(
        "put3(shadowCoordinates(vec2(a(0), a(1)), a(2), a(3), a(4)));", 3,
        [](Random& r) {
            return Inputs{r.between(-3, 3), r.between(-3, 3), r.magnitude(1e-3, 20.0),
                          r.magnitude(0.2, 100.0), 0.05F};
        },
        [](const Doubles& a) {
            const glm::dvec3 at = shader::shadowCoordinates({a[0], a[1]}, a[2], a[3], a[4]);
            return Doubles{at.x, at.y, at.z};
        },
        {5e-7, 1e-6});
}

constexpr const char* kEarth =
    "Air air; air.groundRadius = 6.36e6; air.top = 60e3; air.rayleighHeight = 8e3;"
    "air.mieHeight = 1.2e3; air.rayleighScattering = vec3(5.8e-6, 13.5e-6, 33.1e-6);"
    "air.mieScattering = vec3(4e-6); air.mieExtinction = vec3(4.44e-6); air.mieG = 0.8;";

shader::Air earth() {
    shader::Air air{};
    air.groundRadius = 6.36e6;
    air.top = 60e3;
    air.rayleighHeight = 8e3;
    air.mieHeight = 1.2e3;
    air.rayleighScattering = {5.8e-6, 13.5e-6, 33.1e-6};
    air.mieScattering = glm::dvec3(4e-6);
    air.mieExtinction = glm::dvec3(4.44e-6);
    return air;
}

TEST_F(ShaderFunctions, Air) {
    const shader::Air air = earth();
    const std::string given = kEarth;
    // Rays that do not come within a metre of grazing the ground, where a bit of mu decides.
    const auto draw = [&](Random& r) {
        for (;;) {
            const float h = r.magnitude(1e-3, 6e4);
            const float mu = r.between(-1, 1);
            if (std::abs(shader::lowestHeight(air, double(h), double(mu))) > 1.0) {
                return Inputs{h, mu, r.between(0, 1)};
            }
        }
    };
    const auto length = [&](const Doubles& a) {
        return shader::distanceInAir(air, a[0], a[1], shader::hitsGround(air, a[0], a[1]));
    };
    compare(given +
                "bool ground = hitsGround(air, a(0), a(1)); put(0, ground ? 1.0 : 0.0);"
                "put(1, distanceInAir(air, a(0), a(1), ground));",
            2, draw,
            [&](const Doubles& a) {
                return Doubles{shader::hitsGround(air, a[0], a[1]) ? 1.0 : 0.0, length(a)};
            },
            {2e-5, 1e-2});
    // At a distance the same for both; 0.03 m is what singles keep of heights.
    const std::string part = given + "float t = a(2) * 1e5;";
    compare(part + "put(0, heightAlong(air, a(0), a(1), t));", 1, draw,
            [&](const Doubles& a) {
                return Doubles{shader::heightAlong(air, a[0], a[1], double(float(a[2]) * 1e5F))};
            },
            {5e-7, 0.06});
    compare(given + "put3(airExtinction(air, a(0)) * 1e6);", 3, draw,
            [&](const Doubles& a) {
                const glm::dvec3 value = 1e6 * shader::airExtinction(air, a[0]);
                return Doubles{value.x, value.y, value.z};
            },
            {3e-6, 0.0});
    compare(
        "put(0, chapman(a(0), a(1))); put(1, chapmanSchuler(a(0), a(1)));", 2,
        [](Random& r) {
            return Inputs{r.between(795, 5300), r.between(-0.05, 1)};
        },
        [](const Doubles& a) {
            return Doubles{shader::chapman(a[0], a[1]), shader::chapmanSchuler(a[0], a[1])};
        },
        {2e-5, 0.0});
}

TEST_F(ShaderFunctions, PlanetShadow) {
    const shader::Air air = earth();
    // The sun clearly under the horizon of the start, which then lies in the shadow.
    compare(
        std::string(kEarth) +
            "float entry; float exit;"
            "planetShadow(air, a(0), a(1), a(2), a(3), entry, exit);"
            "put(0, entry); put(1, min(exit, 1e7));",
        2,
        [](Random& r) {
            const float mu = r.between(0.1, 1);
            const float muS = r.between(-0.9, -0.2);
            const auto sines = double(std::sqrt((1.0F - mu * mu) * (1.0F - muS * muS)));
            return Inputs{r.magnitude(1e-3, 6e4), mu, muS,
                          mu * muS + r.between(-0.9 * sines, 0.9 * sines)};
        },
        [&](const Doubles& a) {
            double entry = 0.0;
            double exit = 0.0;
            shader::planetShadow(air, a[0], a[1], a[2], a[3], entry, exit);
            return Doubles{entry, std::min(exit, 1e7)};
        },
        {2e-5, 1.0});
}

}  // namespace
}  // namespace ribalta::test
