// FLIP: how different two pictures look when flipped between on a screen.
// Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images", HPG. LDR-FLIP only.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "measure/rgb_picture.h"

namespace ribalta {

/// The paper's viewer: 0.7 m before a screen 0.7 m wide with 3840 pixels.
inline constexpr double kFlipPixelsPerDegree = 3840.0 * 3.14159265358979323846 / 180.0;

/// What FLIP sees in one picture: filtered colours (section 4.1) and features (section 4.2).
struct FlipView {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> colors;    ///< L*a*b*, blurred as by the eye, Hunt-adjusted
    std::vector<glm::vec2> features;  ///< strength of edges and of points
};

/// `display` holds sRGB-encoded values in 0..1.
FlipView flipView(const RgbPicture& display, double pixelsPerDegree = kFlipPixelsPerDegree);

/// The difference at every pixel, 0..1, rows from the top; both views of one size.
std::vector<float> flipErrors(const FlipView& a, const FlipView& b);

}  // namespace ribalta
