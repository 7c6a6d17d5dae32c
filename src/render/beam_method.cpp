#include "render/beam_method.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace ribalta {
namespace {

constexpr std::array kMethods = {BeamMethod::kPlanes, BeamMethod::kMarch, BeamMethod::kClipped,
                                 BeamMethod::kAdaptive};
constexpr std::array<std::string_view, kMethods.size()> kNames = {"planes", "march", "clipped",
                                                                  "adaptive"};

}  // namespace

std::string_view name(BeamMethod method) {
    const auto place = std::find(kMethods.begin(), kMethods.end(), method);
    CHECK(place != kMethods.end());
    return kNames.at(std::size_t(place - kMethods.begin()));
}

std::optional<BeamMethod> beamMethodNamed(std::string_view wanted) {
    for (const BeamMethod method : kMethods) {
        if (name(method) == wanted) {
            return method;
        }
    }
    return std::nullopt;
}

std::span<const BeamMethod> allBeamMethods() {
    return kMethods;
}

}  // namespace ribalta
