// Stage: draws set-ups with the renderer, one after another with the same programs.
#pragma once

#include <memory>
#include <optional>

#include "image/image.h"
#include "reference/interval.h"
#include "render/beam_method.h"
#include "set_up.h"

namespace ribalta::stress {

/// A drawn set-up.
struct Drawn {
    FloatImage image;  ///< R, G, B; beams.R, .G, .B; transmittance; rows from the top
    std::optional<double> ev100;
    double tolerance = 0.0;  ///< of `adaptive`, share of the screen's full scale
    int shadowSide = 0;      ///< texels, 0: no shadow maps
    /// Metres along the view axis between which the method samples; none: wherever there is light.
    std::optional<Interval> sampledDepths;

    /// Three channels of a pixel: "" for the whole radiance, or a layer's name.
    glm::dvec3 color(int x, int y, const char* layer) const;
};

class Stage {
  public:
    /// Needs a current OpenGL context.
    Stage();
    ~Stage();

    /// `ev100`: exposure; none: found from the picture.
    Drawn draw(const SetUp& setUp, BeamMethod method,
               const std::optional<double>& ev100 = std::nullopt);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ribalta::stress
