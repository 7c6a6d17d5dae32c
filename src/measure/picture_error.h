// PictureError: how far one picture is from another, in numbers. B is the one that is taken for
// right. No file is read here; pictures are finite and of one size.
#pragma once

#include <vector>

#include "measure/flip.h"
#include "measure/rgb_picture.h"

namespace ribalta {

/// The channel of a pixel where the two differ most.
struct LargestError {
    int x = 0;  ///< from the left
    int y = 0;  ///< from the top
    int channel = 0;
    double a = 0.0;
    double b = 0.0;

    double size() const { return a < b ? b - a : a - b; }
};

/// Of luminance in cd/m2.
struct LinearError {
    /// Root of the mean square of A - B over all pixels and channels, divided by the root of the
    /// mean square of B. 0 where both are black, infinite where B alone is.
    double relativeRmse = 0.0;
    LargestError largest;
};
LinearError linearError(const RgbPicture& a, const RgbPicture& b);

/// Of sRGB-encoded display values, full scale 1.
struct DisplayError {
    /// Root of the mean square of A - B over all pixels and channels, in % of full scale.
    double rmsePercent = 0.0;
    /// 10 log10(255^2 / MSE) in dB of both rounded to 8 bits; infinite where these are equal.
    double psnr = 0.0;
    double flipMean = 0.0;  ///< mean of FLIP's error over the picture, 0..1
    double flipLargest = 0.0;
    LargestError largest;
};
/// DisplayError::rmsePercent alone.
double displayRmsePercent(const RgbPicture& a, const RgbPicture& b);
DisplayError displayError(const RgbPicture& a, const RgbPicture& b);
/// The same where B's view is at hand.
DisplayError displayError(const RgbPicture& a, const RgbPicture& b, const FlipView& viewOfB);

}  // namespace ribalta
