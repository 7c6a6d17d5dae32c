// Exposure: the EV100 that the tone mapping uses, given or found from the picture, and its curve.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/tone_curve.h"

namespace ribalta {

class ExposureMeter {
  public:
    /// Defines of passes/exposure.comp.
    explicit ExposureMeter(std::vector<std::string> defines = {}) : defines_(std::move(defines)) {}

    /// Leaves `ev100`, or without it one that suits `color` (cd/m2), bound at kExposureSlot, and
    /// the curve beside it.
    void draw(const std::optional<double>& ev100, ToneCurve curve, const Texture2D& color);

    /// The EV100 of the last draw; waits for the GPU.
    double ev100() const;

  private:
    std::vector<std::string> defines_;
    Program program_;  ///< made when an exposure is first looked for
    Buffer exposure_;
};

}  // namespace ribalta
