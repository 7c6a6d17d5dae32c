#include "measure/sweep_view.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/check.h"
#include "measure/display_picture.h"
#include "measure/picture_error.h"

namespace ribalta {
namespace {

RgbPicture addPictures(const RgbPicture& a, const RgbPicture& b) {
    CHECK(a.width == b.width && a.height == b.height);
    RgbPicture sum{a.width, a.height, {}};
    sum.pixels.resize(a.pixels.size());
    std::transform(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), sum.pixels.begin(),
                   std::plus<>());
    return sum;
}

}  // namespace

SweepView::SweepView(RgbPicture surfaces, std::vector<ReferenceBeams> references,
                     std::optional<double> ev100, ToneCurve toneCurve)
    : surfaces_(std::move(surfaces)),
      references_(std::move(references)),
      ev100_(ev100.value_or(0.0)),
      toneCurve_(toneCurve) {
    if (!ev100 && !references_.empty()) {
        ev100_ = autoExposure(addPictures(surfaces_, references_.front().beams));
    }
    for (const ReferenceBeams& reference : references_) {
        Shown shown{show(reference.beams), {}};
        shown.flip = flipView(shown.display);
        shown_.push_back(std::move(shown));
    }
}

RgbPicture SweepView::show(const RgbPicture& beams) const {
    return displayPicture(addPictures(surfaces_, beams), ev100_, toneCurve_);
}

std::vector<SweepError> SweepView::errorsOf(const RgbPicture& beams,
                                            const RgbPicture& shown) const {
    std::vector<SweepError> errors;
    for (std::size_t i = 0; i < references_.size(); ++i) {
        const DisplayError display = displayError(shown, shown_[i].display, shown_[i].flip);
        errors.push_back(
            {references_[i].against, linearError(beams, references_[i].beams).relativeRmse,
             display.rmsePercent, display.psnr, display.flipMean, references_[i].relativeRms});
    }
    return errors;
}

}  // namespace ribalta
