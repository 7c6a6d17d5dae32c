#include "render/beam_method.h"

#include <array>

namespace ribalta {
namespace {

constexpr std::array kMethods = {BeamMethod::kPlanes, BeamMethod::kClipped};

}  // namespace

std::string_view name(BeamMethod method) {
    switch (method) {
        case BeamMethod::kPlanes:
            return "planes";
        case BeamMethod::kClipped:
            break;
    }
    return "clipped";
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
