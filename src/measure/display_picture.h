// From luminance to what a screen shows, on the CPU: the renderer's own exposure, tone curve and
// encoding, in floats, without rounding to 8 bits and without dither.
#pragma once

#include "measure/rgb_picture.h"
#include "render/tone_curve.h"

namespace ribalta {

/// sRGB-encoded display values in 0..1 of a linear picture in cd/m2 at an exposure in EV100.
RgbPicture displayPicture(const RgbPicture& linear, double ev100,
                          ToneCurve curve = ToneCurve::kNeutral);

/// The same of one pixel.
glm::dvec3 displayPixel(const glm::dvec3& linear, double ev100, ToneCurve curve);

/// The EV100 that the renderer finds for a linear picture in cd/m2 (see lib/auto_exposure.glsl).
double autoExposure(const RgbPicture& linear);

}  // namespace ribalta
