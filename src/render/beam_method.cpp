#include "render/beam_method.h"

#include <array>

namespace ribalta {

std::span<const Named<BeamMethod>> beamMethods() {
    static constexpr std::array<Named<BeamMethod>, 4> kMethods = {
        {{BeamMethod::kPlanes, "planes"},
         {BeamMethod::kMarch, "march"},
         {BeamMethod::kClipped, "clipped"},
         {BeamMethod::kAdaptive, "adaptive"}}};
    return kMethods;
}

}  // namespace ribalta
