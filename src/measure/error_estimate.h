// ErrorEstimate: how far the beams of a picture are from the reference, from a sample of its pixels
// that grows in the background.
#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

#include "measure/rgb_picture.h"
#include "reference/reference_picture.h"
#include "render/renderer.h"

namespace ribalta {

class ErrorEstimate {
  public:
    /// Whose visibility the reference has: the renderer's own shadow maps', so that the error is
    /// that of integration, or that of the scene's triangles, the truth.
    enum class Against { kShadowMaps, kGeometry };

    /// Draws the view twice, reads it back, and begins. `settings` have a haze and no sky;
    /// `ev100` is the exposure that errors are shown at. Needs a current context, now alone. The
    /// scene must outlive it and stay as it is. Throws Error(kJobFailed).
    ErrorEstimate(Renderer& renderer, const Scene& scene, const Camera& camera,
                  const FrameSettings& settings, double ev100, Against against);
    /// Ends the work, which takes as long as a pixel of it.
    ~ErrorEstimate() = default;
    ErrorEstimate(const ErrorEstimate&) = delete;
    ErrorEstimate& operator=(const ErrorEstimate&) = delete;

    struct Value {
        /// As DisplayError::rmsePercent, of the picture with the drawn beams against the same with
        /// the reference's.
        double rmsePercent = 0.0;
        double uncertainty = 0.0;  ///< standard error of that, in the same unit
        std::size_t pixels = 0;    ///< looked at so far
        bool isDone = false;       ///< the uncertainty is small, or all pixels were looked at
        std::string failure;       ///< why there is no value; empty: there is one
    };
    /// What is known by now. May be called from any thread.
    Value value() const;

  private:
    void run(const std::stop_token& stop, const Scene& scene, Against against);
    double squareError(int x, int y, const glm::dvec3& beams) const;

    DrawnFrame drawn_;
    RgbPicture total_;
    RgbPicture beams_;
    ReferenceSettings reference_;
    double ev100_;
    ToneCurve toneCurve_;
    mutable std::mutex mutex_;
    Value value_;          ///< guarded by mutex_
    std::jthread thread_;  ///< last: uses the above
};

}  // namespace ribalta
