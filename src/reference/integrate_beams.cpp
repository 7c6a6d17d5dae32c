// Single scattering out of spot beams, lamp by lamp, adaptively along the ray.
#include "reference/integrate_beams.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/check.h"
#include "optics/shader_lib.h"
#include "reference/beam_lamp.h"
#include "reference/light_map_integral.h"
#include "reference/light_map_pyramid.h"
#include "reference/smooth_panel.h"

namespace ribalta {
namespace {

/// Where a ray without end is cut, metres; what lies beyond holds less than 1e-8 of a beam that is
/// nearer than 10 m to the ray.
constexpr double kEndlessMetres = 1e9;

/// A panel over which the haze takes more than exp(-this) is halved before it is looked at: its
/// nodes might all lie where nothing is left.
constexpr double kMaxPanelDepth = 12.0;
/// Beyond this many optical depths more than where the light begins nothing is left: 2e-20.
constexpr double kLostDepth = 45.0;
/// Halvings after which a panel is taken as it is; its error says how good that is.
constexpr int kMaxHalvings = 40;
/// Evaluations after which panels are no longer halved: along a cone's very edge the falloff is
/// rounding alone, which no polynomial follows.
constexpr int kMaxEvaluations = 400000;

static_assert(int(PhaseFunction::Kind::kGibbons) == shader::kPhaseGibbons &&
              int(PhaseFunction::Kind::kIsotropic) == shader::kPhaseIsotropic &&
              int(PhaseFunction::Kind::kHenyeyGreenstein) == shader::kPhaseHenyeyGreenstein &&
              int(PhaseFunction::Kind::kCornetteShanks) == shader::kPhaseCornetteShanks &&
              int(PhaseFunction::Kind::kRayleigh) == shader::kPhaseRayleigh);

/// The integrand without the light map, for one candela.
class SmoothFactor {
  public:
    SmoothFactor(const BeamSegment& segment, const Haze& haze)
        : segment_(segment),
          haze_(haze),
          extinction_(haze.extinctionPerMetre()),
          isCone_(segment.lamp.light.beamShape == BeamShape::kCone) {}

    double operator()(double x) const {
        const BeamLamp& lamp = segment_.lamp;
        const double t = segment_.distanceAt(x);
        const glm::dvec3 point = segment_.origin + t * segment_.direction;
        const double r = glm::length(point);
        const double phase = shader::phaseFunction(
            static_cast<int>(haze_.phase.kind), shader::scatteringCosine(point, segment_.direction),
            haze_.phase.g, haze_.phase.k);
        double value =
            shader::scatteredIntensity(phase, haze_.scatteringPerMetre, extinction_, r, t) *
            segment_.part.length() * shader::projectiveWeight(x, segment_.z0, segment_.z1);
        if (lamp.inverseRange > 0.0) {
            value *= shader::rangeWindow(r, lamp.inverseRange);
        }
        if (isCone_) {
            value *= shader::coneFalloff(point.z / r, lamp.cosInner, lamp.cosOuter);
        }
        return value;
    }

    /// Optical depth of the light's whole way, lamp to point to eye. Never falls along the ray.
    double opticalDepth(double x) const {
        const double t = segment_.distanceAt(x);
        return extinction_ * (t + glm::length(segment_.origin + t * segment_.direction));
    }

  private:
    const BeamSegment& segment_;
    const Haze& haze_;
    double extinction_;
    bool isCone_;
};

/// Which level of the light map the pixel's width asks for along a ray: the one whose texels are as
/// wide. Between levels the two are blended.
class LightMapLevels {
  public:
    LightMapLevels(const BeamSegment& segment, const BeamRay& ray)
        : segment_(segment), width_(ray.width), widening_(ray.widening) {
        if (segment.lamp.lightMap != nullptr) {
            texels_ = segment.lamp.lightMapTexels();
            last_ = segment.lamp.lightMap->lastLevel();
        }
    }

    /// Fractional, 0..last level.
    double at(double x) const {
        const double t = segment_.distanceAt(x);
        const double z = segment_.origin.z + t * segment_.direction.z;
        const double footprint = texels_ * (width_ + widening_ * t) / z;
        return glm::clamp(std::log2(std::max(footprint, 1e-4)), 0.0, double(last_));
    }

    /// Every x at which the level is whole; there, what it blends changes.
    void addKinks(std::vector<double>& places) const {
        for (int level = 0; level <= last_ && (width_ > 0.0 || widening_ > 0.0); ++level) {
            // texels (width + widening t) = 2^level (origin.z + t direction.z)
            const double size = std::exp2(level);
            const double t = (size * segment_.origin.z - texels_ * width_) /
                             (texels_ * widening_ - size * segment_.direction.z);
            if (t > segment_.part.first && t < segment_.part.last) {
                places.push_back(segment_.placeOf(t));
            }
        }
    }

  private:
    const BeamSegment& segment_;
    double width_;
    double widening_;
    double texels_ = 0.0;
    int last_ = -1;
};

/// The stretches with a cut at every place inside them; both ascending.
std::vector<Interval> cutAt(const std::vector<Interval>& stretches,
                            const std::vector<double>& places) {
    std::vector<Interval> pieces;
    auto place = places.begin();
    for (Interval rest : stretches) {
        for (; place != places.end() && *place < rest.last; ++place) {
            if (*place > rest.first) {
                pieces.push_back({rest.first, *place});
                rest.first = *place;
            }
        }
        pieces.push_back(rest);
    }
    return pieces;
}

/// One lamp's light along one ray, gathered panel by panel.
class SegmentIntegral {
  public:
    SegmentIntegral(const BeamSegment& segment, const LightMapLevels& levels, const Haze& haze,
                    double relative)
        : segment_(segment), levels_(levels), factor_(segment, haze), relative_(0.85 * relative) {
        if (segment.lamp.lightMap != nullptr) {
            uv0_ = segment.lamp.lightMapUv(segment.slope0);
            uv1_ = segment.lamp.lightMapUv(segment.slope1);
        }
    }

    /// A lit stretch without kinks.
    void add(const Interval& stretch) {
        const double depthFirst = factor_.opticalDepth(stretch.first);
        const double depthLast = factor_.opticalDepth(stretch.last);
        if (leastDepth_ < 0.0) {
            leastDepth_ = depthFirst;
        }
        const LightMapPyramid* const map = segment_.lamp.lightMap;
        if (map == nullptr) {
            add(stretch, depthFirst, depthLast, 0, nullptr, factor_);
            return;
        }
        const double level = levels_.at(0.5 * (stretch.first + stretch.last));
        const int finer = int(level);
        if (level == finer) {
            add(stretch, depthFirst, depthLast, 0, &map->level(finer), factor_);
            return;
        }
        const auto coarseShare = [&](double x) {
            return glm::clamp(levels_.at(x) - finer, 0.0, 1.0);
        };
        add(stretch, depthFirst, depthLast, 0, &map->level(finer),
            [&](double x) { return factor_(x) * (1.0 - coarseShare(x)); });
        add(stretch, depthFirst, depthLast, 0, &map->level(finer + 1),
            [&](double x) { return factor_(x) * coarseShare(x); });
    }

    BeamLight result() const { return result_; }

  private:
    /// `smooth` times the map, or times one where there is none.
    template <typename Smooth>
    void add(const Interval& place, double depthFirst, double depthLast, int halvings,
             const LightMapTexture* map, const Smooth& smooth) {
        if (!(place.length() > 0.0) || depthFirst - leastDepth_ > kLostDepth) {
            return;
        }
        const bool canHalve = halvings < kMaxHalvings && result_.evaluations < kMaxEvaluations;
        if (!(depthLast - depthFirst > kMaxPanelDepth && canHalve)) {
            const SmoothPanel panel = fitPanel(smooth, place);
            result_.evaluations += int(SmoothPanel::kNodes);
            peak_ = std::max(peak_, panel.largest);
            // What counts is the error against the panel's own light, or against 1e-5 of
            // the brightest where the panel adds next to nothing.
            const double mean = panel.integral() / place.length();
            const double own = std::max({panel.smallest, 0.1 * mean, 0.0});
            if (panel.error() <= relative_ * std::max(own, 1e-5 * peak_) || !canHalve) {
                take(panel, own, map);
                return;
            }
        }
        const double middle = 0.5 * (place.first + place.last);
        const double depthMiddle = factor_.opticalDepth(middle);
        add({place.first, middle}, depthFirst, depthMiddle, halvings + 1, map, smooth);
        add({middle, place.last}, depthMiddle, depthLast, halvings + 1, map, smooth);
    }

    void take(const SmoothPanel& panel, double own, const LightMapTexture* map) {
        glm::dvec3 value(panel.integral());
        double rule = 0.0;
        if (map != nullptr) {
            rule = 0.1 * relative_;
            value = integrateOverLightMap(panel, *map, uv0_, uv1_, rule);
        }
        value *= segment_.lamp.candela;
        result_.value += value;
        const double largest = std::max({value.x, value.y, value.z});
        result_.error += largest * (own > 0.0 ? std::min(panel.error() / own, 1.0) + rule : 1.0);
    }

    const BeamSegment& segment_;
    const LightMapLevels& levels_;
    SmoothFactor factor_;
    double relative_;  ///< of a panel; the rest is for the light map's rule
    glm::dvec2 uv0_{0.0};
    glm::dvec2 uv1_{0.0};
    double leastDepth_ = -1.0;  ///< optical depth where the light begins
    double peak_ = 0.0;         ///< largest value of the smooth factor so far
    BeamLight result_;
};

}  // namespace

struct BeamIntegrator::State {
    std::vector<BeamLamp> lamps;
    std::vector<std::unique_ptr<LightMapPyramid>> lightMaps;  // by image; null where no lamp asks
    Haze haze;
    std::unique_ptr<BeamVisibility> visibility;
    double relativeError = 0.0;

    BeamLight alongSegment(const BeamSegment& segment, const BeamRay& ray) const;
};

BeamLight BeamIntegrator::State::alongSegment(const BeamSegment& segment,
                                              const BeamRay& ray) const {
    std::vector<Interval> lit = {{0.0, 1.0}};
    if (visibility) {
        visibility->findLit(segment, lit);
    }
    std::vector<double> kinks;
    if (const std::optional<Interval> full =
            segment.lamp.fullCone(segment.origin, segment.direction, segment.part)) {
        kinks = {segment.placeOf(full->first), segment.placeOf(full->last)};
    }
    const LightMapLevels levels(segment, ray);
    levels.addKinks(kinks);
    std::sort(kinks.begin(), kinks.end());
    SegmentIntegral integral(segment, levels, haze, relativeError);
    for (const Interval& stretch : cutAt(lit, kinks)) {
        integral.add(stretch);
    }
    return integral.result();
}

BeamIntegrator::BeamIntegrator(std::span<const SpotLight> lamps, std::span<const Image> images,
                               const Haze& haze, std::unique_ptr<BeamVisibility> visibility,
                               double relativeError)
    : state_(std::make_unique<State>()) {
    CHECK(relativeError >= 1e-12 && relativeError <= 0.1);
    state_->haze = haze;
    state_->visibility = std::move(visibility);
    state_->relativeError = relativeError;
    state_->lightMaps.resize(images.size());
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        const LightMapPyramid* lightMap = nullptr;
        if (lamps[i].lightMap) {
            const int image = lamps[i].lightMap->image;
            CHECK(image >= 0 && std::size_t(image) < images.size());
            std::unique_ptr<LightMapPyramid>& texture = state_->lightMaps[std::size_t(image)];
            if (!texture) {
                texture = std::make_unique<LightMapPyramid>(images[std::size_t(image)]);
            }
            lightMap = texture.get();
        }
        BeamLamp lamp(lamps[i], int(i), lightMap);
        if (!lamp.isDark()) {
            state_->lamps.push_back(std::move(lamp));
        }
    }
}

BeamIntegrator::~BeamIntegrator() = default;
BeamIntegrator::BeamIntegrator(BeamIntegrator&&) noexcept = default;
BeamIntegrator& BeamIntegrator::operator=(BeamIntegrator&&) noexcept = default;

std::span<const BeamLamp> BeamIntegrator::lamps() const {
    return state_->lamps;
}

BeamLight BeamIntegrator::along(const BeamRay& ray) const {
    BeamLight total;
    if (!(state_->haze.scatteringPerMetre > 0.0)) {
        return total;
    }
    const Interval interval{ray.first, std::min(ray.last, kEndlessMetres)};
    for (const BeamLamp& lamp : state_->lamps) {
        const std::optional<BeamSegment> segment =
            BeamSegment::make(lamp, ray.origin, ray.direction, interval);
        if (!segment) {
            continue;
        }
        const BeamLight one = state_->alongSegment(*segment, ray);
        total.value += one.value;
        total.error += one.error;
        total.evaluations += one.evaluations;
    }
    return total;
}

}  // namespace ribalta
