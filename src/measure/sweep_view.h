// SweepView: the right answers for one scene, camera, size and haze, and how far pictures of it are
// from them. Where the answers come from is not its business.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measure/flip.h"
#include "measure/rgb_picture.h"
#include "measure/sweep_record.h"

namespace ribalta {

/// The beams that would be right, seen by one kind of visibility.
struct ReferenceBeams {
    std::string against;       ///< "shadow-map" or "geometry"
    RgbPicture beams;          ///< cd/m2
    double relativeRms = 0.0;  ///< estimated error of it
};

class SweepView {
  public:
    /// `surfaces` are the renderer's own, in cd/m2, without beams: every picture is shown on the
    /// same ones, so that what differs are beams alone. Where none is given, the first reference
    /// gives the exposure. Without references no errors are given.
    SweepView(RgbPicture surfaces, std::vector<ReferenceBeams> references,
              std::optional<double> ev100 = std::nullopt,
              ToneCurve toneCurve = ToneCurve::kNeutral);

    /// EV100 at which pictures are shown.
    double ev100() const { return ev100_; }
    bool hasReferences() const { return !references_.empty(); }

    /// Display picture of beams in cd/m2 on the view's surfaces.
    RgbPicture show(const RgbPicture& beams) const;
    /// The same of the first reference.
    const RgbPicture& shownReference() const { return shown_.front().display; }

    /// From every reference, in their order. `beams` are finite.
    std::vector<SweepError> errorsOf(const RgbPicture& beams, const RgbPicture& shown) const;

  private:
    struct Shown {
        RgbPicture display;
        FlipView flip;
    };

    RgbPicture surfaces_;
    std::vector<ReferenceBeams> references_;
    double ev100_ = 0.0;
    ToneCurve toneCurve_ = ToneCurve::kNeutral;
    std::vector<Shown> shown_;
};

}  // namespace ribalta
