#include "scene/haze.h"

#include <array>

namespace ribalta {

std::span<const Named<PhaseFunction::Kind>> phaseFunctions() {
    using Kind = PhaseFunction::Kind;
    static constexpr std::array<Named<Kind>, 5> kKinds = {
        {{Kind::kGibbons, "gibbons"},
         {Kind::kIsotropic, "isotropic"},
         {Kind::kRayleigh, "rayleigh"},
         {Kind::kHenyeyGreenstein, "hg"},
         {Kind::kCornetteShanks, "cornette-shanks"}}};
    return kKinds;
}

}  // namespace ribalta
