// Pictures against the double-precision answer, pixel by pixel within bounds of their own.
#include "check_set_up.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <glm/gtx/component_wise.hpp>
#include <shared/beams.h>

#include "exact_beams.h"
#include "optics/shader_lib.h"
#include "random.h"
#include "reference/integrate_beams.h"

namespace ribalta::stress {
namespace {

/// Half a unit in the last place of single precision.
constexpr double kEpsilon = 0x1p-24;
/// A beam ends this share of the distance before the surface behind it.
constexpr double kBeforeSurface = 1e-4;
/// Roundings that a ray's place and direction may have gathered.
constexpr double kRoundings = 8.0;
/// By how many tolerances `adaptive` may be off where it interpolates: what bends across and what
/// bends down add, and it looks at the larger of the two.
constexpr double kBendsBothWays = 2.0;
/// Points at which the reference asks for shadows, half of them even in the lamp's projection.
constexpr int kProbes = 2048;
/// Share of the brightest pixel that no one sees.
constexpr double kUnseen = 1e-9;
/// What underflows in single precision, cd/m2 for a candela.
constexpr double kUnderflow = 1e-33;

/// The geometry of one pixel's ray, by the definition of the cameras.
struct PixelRay {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0};
    double metresPerDepth = 1.0;
};

PixelRay pixelRay(const SetUp& setUp, double x, double y) {
    const Camera& camera = setUp.camera;
    const glm::dvec2 half = viewHalfExtent(camera, setUp.width, setUp.height);
    const glm::dvec3 aside = ((x + 0.5) / setUp.width * 2.0 - 1.0) * half.x * camera.frame.right() +
                             (1.0 - (y + 0.5) / setUp.height * 2.0) * half.y * camera.frame.up();
    if (camera.isOrthographic()) {
        return {camera.frame.position + aside, camera.frame.forward(), 1.0};
    }
    const glm::dvec3 unscaled = camera.frame.forward() + aside;
    const double length = glm::length(unscaled);
    return {camera.frame.position, unscaled / length, length};
}

/// Metres to the first rectangle at or behind `first`; infinity where there is none.
double hit(const SetUp& setUp, const glm::dvec3& origin, const glm::dvec3& direction,
           double first) {
    double nearest = kInfinity;
    for (const Rectangle& rectangle : setUp.rectangles) {
        const glm::dvec3 normal = glm::cross(rectangle.halfU, rectangle.halfV);
        const double t = glm::dot(normal, rectangle.centre - origin) / glm::dot(normal, direction);
        const glm::dvec3 place = origin + t * direction - rectangle.centre;
        const double u =
            glm::dot(place, rectangle.halfU) / glm::dot(rectangle.halfU, rectangle.halfU);
        const double v =
            glm::dot(place, rectangle.halfV) / glm::dot(rectangle.halfV, rectangle.halfV);
        if (t >= first && std::abs(u) <= 1.0 && std::abs(v) <= 1.0) {
            nearest = std::min(nearest, t);
        }
    }
    return nearest;
}

/// What a method's sums are worth, given how rough the integrand is.
double quadratureBound(const Roughness& roughness, int samples) {
    const double n = samples;
    return std::min(roughness.variation / (2.0 * n),
                    1.5 * roughness.slopeVariation / (8.0 * n * n)) +
           roughness.lightMapChange;
}

/// What a screen shows, 0..1.
glm::dvec3 shown(const glm::dvec3& luminance, double ev100) {
    return shader::srgbEncode(shader::toneNeutral(luminance * shader::exposureFromEv100(ev100)));
}

class PixelCheck {
  public:
    PixelCheck(const SetUp& setUp, BeamMethod method, const Drawn& drawn)
        : setUp_(setUp), drawn_(drawn), exact_(setUp, drawn.shadowSide), method_(method) {
        for (const SpotLight& lamp : setUp.lamps) {
            candela_ = std::max(candela_, lamp.intensityCandela);
            lampMetres_ = std::max(lampMetres_,
                                   glm::length(lamp.frame.position - setUp.camera.frame.position));
        }
    }

    glm::dvec3 exact(int x, int y) const { return exact_.along(rayOf(pixelRay(setUp_, x, y))); }

    /// Rounding of the sum itself: what every picture must keep.
    double rounding(const glm::dvec3& value) const {
        const PhaseFunction& phase = setUp_.haze.phase;
        const bool sharp = phase.kind == PhaseFunction::Kind::kHenyeyGreenstein ||
                           phase.kind == PhaseFunction::Kind::kCornetteShanks;
        // Three halves of the relative error of 1 + g^2 - 2 g mu >= (1 - |g|)^2.
        const double peak = sharp ? 12.0 * kEpsilon / std::pow(1.0 - std::abs(phase.g), 2.0) : 0.0;
        // Partial sums of n terms alike are n / 2 of them on average, each rounded.
        const double sum = 0.5 * kEpsilon * setUp_.sheets;
        // exp of a rounded optical depth; beyond 90 nothing is left.
        const double haze =
            4.0 * kEpsilon * std::min(2.0 * lampMetres_ * setUp_.haze.extinctionPerMetre(), 90.0);
        return glm::compMax(value) * (2e-5 + sum + peak + haze) +
               kUnderflow * std::max(candela_, 1.0);
    }

    /// Whether the screen shows two values of a pixel's beams alike, as far as interpolation may.
    bool looksAlike(const glm::ivec2& pixel, const glm::dvec3& a, const glm::dvec3& b) const {
        return shownDifference(pixel, a, b) <= kBendsBothWays * drawn_.tolerance;
    }

    /// Share of the screen's full scale.
    double shownDifference(const glm::ivec2& pixel, const glm::dvec3& a,
                           const glm::dvec3& b) const {
        if (!drawn_.ev100) {
            return 0.0;
        }
        const glm::dvec3 rest =
            drawn_.color(pixel.x, pixel.y, "") - drawn_.color(pixel.x, pixel.y, "beams");
        return glm::compMax(
            glm::abs(shown(rest + a, *drawn_.ev100) - shown(rest + b, *drawn_.ev100)));
    }

    double quadrature(int x, int y) const {
        const Ray ray = rayOf(pixelRay(setUp_, x, y));
        if (method_ == BeamMethod::kPlanes) {
            Roughness roughness = exact_.alongRay(ray);
            roughness.variation *= drawn_.sampledDepths ? planeShare(ray, x, y) : 1.0;
            return quadratureBound(roughness, setUp_.sheets);
        }
        // Half the sheets at least are there where the ray cuts a corner; a march takes all.
        const bool march = name(method_) == "march";
        const int samples = march ? setUp_.sheets : (setUp_.sheets + 1) / 2;
        const glm::dvec2 half = viewHalfExtent(setUp_.camera, setUp_.width, setUp_.height);
        return quadratureBound(exact_.inBeams(ray, samples, march, 2.0 * half.y / setUp_.height,
                                              setUp_.camera.isOrthographic()),
                               samples);
    }

    /// The least and the greatest answer to questions that differ by single precision's rounding,
    /// by the texels of the shadow maps and by where a surface may stop the ray.
    std::array<glm::dvec3, 2> range(int x, int y, const glm::dvec3& value) const {
        std::array<glm::dvec3, 2> result = {value, value};
        const auto add = [&](const Ray& ray, const Change& change = {}) {
            const glm::dvec3 other = exact_.along(ray, change);
            result[0] = glm::min(result[0], other);
            result[1] = glm::max(result[1], other);
        };
        const PixelRay pixel = pixelRay(setUp_, x, y);
        const Ray ray = rayOf(pixel);
        const bool shadows = drawn_.shadowSide > 0;
        for (const double sign : {-1.0, 1.0}) {
            add(ray, {sign * 4.0 * kEpsilon, 0.0});
            if (shadows) {
                add(ray, {0.0, sign * 1.5});
            }
        }
        const glm::dvec3 u = glm::normalize(
            glm::cross(ray.direction, std::abs(ray.direction.x) < 0.6 ? glm::dvec3(1, 0, 0)
                                                                      : glm::dvec3(0, 1, 0)));
        const glm::dvec3 v = glm::cross(ray.direction, u);
        const double metres = kRoundings * kEpsilon * std::max(lampMetres_, extent());
        for (const glm::dvec3& axis : {u, v, ray.direction}) {
            for (const double sign : {-1.0, 1.0}) {
                for (const double tilt : {-1.0, 1.0}) {
                    Ray other = ray;
                    other.origin += sign * metres * axis;
                    if (axis != ray.direction) {
                        other.direction =
                            glm::normalize(ray.direction + tilt * kRoundings * kEpsilon * axis);
                    }
                    add(other);
                }
            }
        }
        if (!setUp_.rectangles.empty() || std::isfinite(setUp_.camera.farMetres)) {
            addEnds(x, y, add);
        }
        return result;
    }

    double lampMetres() const { return lampMetres_; }

    /// Along a cone's very edge the falloff is what double precision rounds: (1e-16 / 0.001)^2.
    double leastFalloff() const { return 1e-22 * candela_ + 1e-30; }

    Ray rayOf(const PixelRay& pixel) const {
        const double first = setUp_.camera.nearMetres * pixel.metresPerDepth;
        return rayTo(pixel, hit(setUp_, pixel.origin, pixel.direction, first));
    }

  private:
    /// The stretch that is drawn of a pixel's ray that a surface stops at `surface` metres.
    Ray rayTo(const PixelRay& pixel, double surface) const {
        // Planes have an end of their own.
        const double end = drawn_.sampledDepths ? kInfinity : double(gpu::kEndOfBeams);
        const double far = std::min(setUp_.camera.farMetres, end) * pixel.metresPerDepth;
        Ray ray{pixel.origin, pixel.direction, setUp_.camera.nearMetres * pixel.metresPerDepth,
                std::min(far, surface)};
        if (drawn_.sampledDepths) {
            ray.first = std::max(ray.first, drawn_.sampledDepths->first * pixel.metresPerDepth);
            ray.last = std::min(ray.last, drawn_.sampledDepths->last * pixel.metresPerDepth);
        }
        return ray;
    }

    template <typename Add>
    void addEnds(int x, int y, const Add& add) const {
        // Vertices are snapped to a 256th of a pixel.
        const double off = 1.0 / 128.0;
        for (const glm::dvec2 aside : {glm::dvec2(0.0), glm::dvec2(off, off), glm::dvec2(-off, off),
                                       glm::dvec2(off, -off), glm::dvec2(-off, -off)}) {
            const PixelRay there = pixelRay(setUp_, x + aside.x, y + aside.y);
            const PixelRay pixel = pixelRay(setUp_, x, y);
            const double first = setUp_.camera.nearMetres * there.metresPerDepth;
            // A surface in the near plane may be seen or not.
            for (const double from : {first * (1.0 - 1e-5), first * (1.0 + 1e-5)}) {
                const double surface = std::min(hit(setUp_, there.origin, there.direction, from),
                                                setUp_.camera.farMetres * there.metresPerDepth);
                const double depthError =
                    setUp_.camera.isOrthographic() ? kEpsilon * setUp_.camera.farMetres : 0.0;
                add(rayTo(pixel, surface * (1.0 - 1.5 * kBeforeSurface) - depthError));
                add(rayTo(pixel, surface * (1.0 + 1e-5) + depthError));
            }
        }
    }

    /// Planes lie evenly over sampledDepths, not over what a surface leaves of the ray.
    double planeShare(const Ray& ray, int x, int y) const {
        const double all = (drawn_.sampledDepths->last - drawn_.sampledDepths->first) *
                           pixelRay(setUp_, x, y).metresPerDepth;
        return ray.last > ray.first ? all / (ray.last - ray.first) : 0.0;
    }

    double extent() const {
        return setUp_.camera.isOrthographic()
                   ? glm::compMax(glm::dvec3(
                         viewHalfExtent(setUp_.camera, setUp_.width, setUp_.height), 0.0))
                   : 0.0;
    }

    const SetUp& setUp_;
    const Drawn& drawn_;
    ExactBeams exact_;
    BeamMethod method_;
    double candela_ = 0.0;
    double lampMetres_ = 0.0;
};

std::string line(const char* what, int x, int y, const glm::dvec3& drawn, const glm::dvec3& exact,
                 double allowed) {
    char text[400];
    std::snprintf(
        text, sizeof text,
        "%s in pixel %d, %d: drawn (%.9g, %.9g, %.9g), expected (%.9g, %.9g, %.9g) cd/m2, "
        "off by %.3g, allowed %.3g",
        what, x, y, drawn.x, drawn.y, drawn.z, exact.x, exact.y, exact.z,
        glm::compMax(glm::abs(drawn - exact)), allowed);
    return text;
}

bool isSound(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) &&
           std::min({v.x, v.y, v.z}) >= 0.0;
}

void checkSound(const char* which, const Drawn& drawn, Findings& findings) {
    if (drawn.ev100 && !std::isfinite(*drawn.ev100)) {
        findings.faults.push_back(std::string(which) + ": the exposure is not finite");
    }
    for (const char* layer : {"", "beams", "transmittance"}) {
        for (int y = 0; y < drawn.image.height; ++y) {
            for (int x = 0; x < drawn.image.width; ++x) {
                const glm::dvec3 color = drawn.color(x, y, layer);
                if (!isSound(color)) {
                    char text[200];
                    std::snprintf(text, sizeof text,
                                  "%s: not finite or negative in pixel %d, %d of %s: (%g, %g, %g)",
                                  which, x, y, *layer == '\0' ? "the picture" : layer, color.x,
                                  color.y, color.z);
                    findings.faults.emplace_back(text);
                    return;  // one tells enough
                }
            }
        }
    }
}

/// A few pixels of every 8 x 8, the brightest and the middle one.
std::vector<glm::ivec2> choosePixels(const Drawn& drawn) {
    const int width = drawn.image.width;
    const int height = drawn.image.height;
    std::vector<glm::ivec2> pixels = {{width / 2, height / 2}};
    Random random(std::uint64_t(width * 1000 + height));
    glm::ivec2 brightest(0);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (glm::compMax(drawn.color(x, y, "beams")) >
                glm::compMax(drawn.color(brightest.x, brightest.y, "beams"))) {
                brightest = {x, y};
            }
        }
    }
    pixels.push_back(brightest);
    for (int y = 0; y < height; y += 8) {
        for (int x = 0; x < width; x += 8) {
            for (int i = 0; i < 2; ++i) {
                pixels.emplace_back(std::min(x + random.below(8), width - 1),
                                    std::min(y + random.below(8), height - 1));
            }
        }
    }
    return pixels;
}

/// Whether a difference is explained; updates the shares. `parts` counts how many bounds of the sum
/// apply: one against the exact answer, two between two drawn pictures.
class Judge {
  public:
    /// `least`: what no one sees of the picture, cd/m2.
    Judge(const PixelCheck& check, double least, Findings& findings)
        : check_(check), least_(least), findings_(findings) {}

    void compare(const char* what, const glm::ivec2& pixel, const glm::dvec3& drawn,
                 const glm::dvec3& expected, const glm::dvec3& exact, bool sameSamples) {
        const double error = glm::compMax(glm::abs(drawn - expected));
        double allowed =
            check_.rounding(glm::max(exact, expected)) * (sameSamples ? 2.0 : 1.0) + least_;
        if (error <= allowed) {
            return;
        }
        // Two drawings take the same samples, so that only rounding can differ.
        if (!sameSamples) {
            allowed += check_.quadrature(pixel.x, pixel.y);
        }
        if (!(error <= allowed)) {
            const auto [low, high] = check_.range(pixel.x, pixel.y, exact);
            // The changes that were tried are some of many: as much again.
            const double spread = glm::compMax(high - low);
            allowed += 2.0 * spread;
            if (sameSamples && spread > 0.0) {
                // A sample may change sides of an edge that moves.
                allowed += check_.quadrature(pixel.x, pixel.y);
            }
        }
        if (!(error <= allowed) && check_.looksAlike(pixel, drawn, expected)) {
            return;
        }
        findings_.worstShare = std::max(findings_.worstShare, error / allowed);
        if (!(error <= allowed)) {
            findings_.faults.push_back(line(what, pixel.x, pixel.y, drawn, expected, allowed));
        }
    }

  private:
    const PixelCheck& check_;
    double least_;
    Findings& findings_;
};

/// Every pixel that `adaptive` interpolates, against its own samples. One that differs because a
/// sample may fall to either side of an edge is right by the exact answer.
void checkInterpolation(const PixelCheck& check, const Drawn& drawn, const Drawn& sampled,
                        Judge& judge) {
    for (int y = 0; y < drawn.image.height; ++y) {
        for (int x = 0; x < drawn.image.width; ++x) {
            const glm::dvec3 value = drawn.color(x, y, "beams");
            if (!check.looksAlike({x, y}, value, sampled.color(x, y, "beams"))) {
                const glm::dvec3 exact = check.exact(x, y);
                judge.compare("interpolated badly", {x, y}, value, exact, exact, false);
            }
        }
    }
}

/// One of the 24 turns that map the axes onto themselves.
glm::dmat3 turnOfCube(Random& random) {
    const int first = random.below(3);
    const int second = (first + 1 + random.below(2)) % 3;
    glm::dmat3 turn(0.0);
    turn[0][first] = random.chance(0.5) ? 1.0 : -1.0;
    turn[1][second] = random.chance(0.5) ? 1.0 : -1.0;
    turn[2] = glm::cross(turn[0], turn[1]);
    return turn;
}

}  // namespace

Findings checkSetUp(const SetUp& setUp, BeamMethod method, Stage& stage) {
    Findings findings;
    // With nothing interpolated `adaptive` is `clipped` to the bit.
    const bool interpolates = method == BeamMethod::kAdaptive;
    const Drawn sampled = stage.draw(setUp, interpolates ? BeamMethod::kClipped : method);
    const Drawn here = interpolates ? stage.draw(setUp, method, sampled.ev100) : sampled;
    checkSound("as it is", here, findings);

    // Where the planes end follows from the scene's box, which turns only with the axes.
    Random random(setUp.seed * 7919 + std::uint64_t(setUp.number));
    const bool planes = method == BeamMethod::kPlanes;
    const glm::dmat3 rotation =
        planes ? turnOfCube(random)
               : lookAt({0, 0, 0}, random.direction(), random.direction()).worldFromLocal;
    const glm::dvec3 metres = random.decades(1.0, 1e5) * random.direction();
    const Drawn there = stage.draw(moved(setUp, rotation, metres), method, here.ev100);
    checkSound("moved", there, findings);
    if (!findings.faults.empty()) {
        return findings;
    }

    const PixelCheck check(setUp, method, here);
    const std::vector<glm::ivec2> pixels = choosePixels(here);
    std::vector<glm::dvec3> exact;
    double brightest = 0.0;
    for (const glm::ivec2& pixel : pixels) {
        exact.push_back(check.exact(pixel.x, pixel.y));
        brightest = std::max(brightest, glm::compMax(exact.back()));
    }
    Judge judge(check, kUnseen * brightest, findings);
    if (interpolates) {
        checkInterpolation(check, here, sampled, judge);
    }
    double error = 0.0;
    double motion = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::ivec2& pixel = pixels[i];
        const glm::dvec3 drawn = here.color(pixel.x, pixel.y, "beams");
        const glm::dvec3 again = there.color(pixel.x, pixel.y, "beams");
        brightest = std::max(brightest, glm::compMax(drawn));
        error = std::max(error, glm::compMax(glm::abs(drawn - exact[i])));
        motion = std::max(motion, glm::compMax(glm::abs(drawn - again)));
        judge.compare("wrong light", pixel, sampled.color(pixel.x, pixel.y, "beams"), exact[i],
                      exact[i], false);
        judge.compare("changed by a rigid motion", pixel, again, drawn, exact[i], true);
        ++findings.pixels;
    }
    if (brightest > 0.0) {
        findings.worstError = error / brightest;
        findings.worstMotion = motion / brightest;
    }
    return findings;
}

Findings checkReference(const SetUp& setUp) {
    Findings findings;
    const Drawn nothing;
    const PixelCheck check(setUp, BeamMethod::kClipped, nothing);
    const auto isLit = [&](const SpotLight& lamp, const glm::dvec3& point) {
        const glm::dvec3 way = point - lamp.frame.position;
        const double length = glm::length(way);
        const glm::dvec3 direction = way / length;
        const double nearMetres = 0.05 / glm::dot(direction, lamp.frame.forward());
        return hit(setUp, lamp.frame.position, direction, nearMetres) >= length;
    };
    std::unique_ptr<BeamVisibility> visibility;
    if (!setUp.rectangles.empty()) {
        visibility = std::make_unique<ProbedVisibility>(isLit, kProbes);
    }
    const BeamIntegrator reference(setUp.lamps, lightMaps(), setUp.haze, std::move(visibility));
    Random random(setUp.seed + 31 * std::uint64_t(setUp.number));
    for (int i = 0; i < 4; ++i) {
        const glm::ivec2 pixel(random.below(setUp.width), random.below(setUp.height));
        const Ray ray = check.rayOf(pixelRay(setUp, pixel.x, pixel.y));
        const glm::dvec3 exact = check.exact(pixel.x, pixel.y);
        const glm::dvec3 value =
            reference.along({ray.origin, ray.direction, ray.first, ray.last}).value;
        const double error = glm::compMax(glm::abs(value - exact));
        // Both ask for 1e-6 of themselves; a shadow's edge is found to 1e-12 of the stretch.
        SetUp open = setUp;
        open.rectangles.clear();
        const double unshadowed = glm::compMax(ExactBeams(open, 0).along(ray));
        // A shadow that begins within the rounding of places may be seen or not, and so may one
        // that fits between two probes.
        double missed = 1e-12 * check.lampMetres() / (ray.last - ray.first);
        missed += setUp.rectangles.empty() ? 0.0 : 4.0 / kProbes;
        const double allowed =
            5e-6 * glm::compMax(exact) + std::min(1.0, missed) * unshadowed + check.leastFalloff();
        findings.worstError = std::max(findings.worstError, error / (glm::compMax(exact) + 1e-30));
        findings.worstShare = std::max(findings.worstShare, error / allowed);
        ++findings.pixels;
        if (!(error <= allowed)) {
            findings.faults.push_back(
                line("the reference is wrong", pixel.x, pixel.y, value, exact, allowed));
        }
    }
    return findings;
}

}  // namespace ribalta::stress
