// Animation pointers (KHR_animation_pointer): which of them are followed, and to what.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "gltf/read_sampler.h"
#include "scene/animation.h"
#include "scene/dial.h"

namespace ribalta::gltf {

/// A property of the document that an animation can change.
struct PointedAt {
    enum class Owner { kNode, kLight, kCamera, kMaterial };

    Owner owner = Owner::kNode;
    std::size_t index = 0;  ///< into the document's list of those; not checked
    /// kDial, or what unextended channels move of a node as well.
    AnimationChannel::Part part = AnimationChannel::Part::kDial;
    Dial::Numbers numbers = Dial::Numbers::kVisible;  ///< of kDial, and of these
    int first = 0;                                    ///< the first that it is,
    int count = 0;                                    ///< and how many
    SamplerUse::Values values = SamplerUse::Values::kNumber;
};

/// Nothing where the JSON pointer names a property that is not animated here.
std::optional<PointedAt> parsePointer(std::string_view pointer);

/// Calls `visit` with every key's value of a sampler, without tangents.
template <typename Visit>
void forEachKeyValue(const AnimationSampler& sampler, const Visit& visit) {
    const bool cubic = sampler.interpolation == AnimationSampler::Interpolation::kCubicSpline;
    for (std::size_t i = cubic ? 1 : 0; i < sampler.values.size(); i += cubic ? 3 : 1) {
        visit(sampler.values[i]);
    }
}

/// A pointer with {} for its numbers, and cut off where it is long: for messages about many alike.
std::string withoutIndices(std::string_view pointer);

}  // namespace ribalta::gltf
