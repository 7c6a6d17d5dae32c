#include "render/tone_curve.h"

#include <array>

#include "optics/shader_lib.h"

namespace ribalta {

static_assert(int(ToneCurve::kNeutral) == shader::kToneNeutral);
static_assert(int(ToneCurve::kAgx) == shader::kToneAgx);
static_assert(int(ToneCurve::kAces) == shader::kToneAces);
static_assert(int(ToneCurve::kLinear) == shader::kToneLinear);

std::span<const Named<ToneCurve>> toneCurves() {
    static constexpr std::array<Named<ToneCurve>, 4> kCurves = {{{ToneCurve::kNeutral, "neutral"},
                                                                 {ToneCurve::kAgx, "agx"},
                                                                 {ToneCurve::kAces, "aces"},
                                                                 {ToneCurve::kLinear, "linear"}}};
    return kCurves;
}

}  // namespace ribalta
