// The keys of one animation sampler: times and values, checked before memory is taken.
#pragma once

#include <compare>
#include <cstddef>

#include "base/report.h"
#include "gltf/import.h"
#include "gltf/tally.h"
#include "scene/animation.h"

namespace ribalta::gltf {

/// Most values of keys that are read, of all animations together; the channels beyond are left out.
inline constexpr std::size_t kMaxAnimationValues = std::size_t(1) << 24U;

/// What a sampler's numbers are for, which says how they are read.
struct SamplerUse {
    enum class Values { kVec3, kRotation, kWeights, kNumber, kVec4, kSwitch };

    Values values = Values::kVec3;
    std::size_t targets = 0;     ///< of kWeights: how many a key has
    bool plainIntegers = false;  ///< integers that are not normalized count as they are
                                 ///< (KHR_animation_pointer); of a kSwitch always
    auto operator<=>(const SamplerUse&) const = default;
};

class SamplerReader {
  public:
    /// What it is given must outlive it.
    SamplerReader(const Import& import, Report& report) : import_(import), report_(report) {}

    /// The sampler at a place. Throws Error(kBadInput) where it cannot be played.
    AnimationSampler read(const nlohmann::json& source, const SamplerUse& use, const Place& place);
    /// To be called once when all are read: reports what was odd of them.
    void tell() { hints_.tell(Report::Kind::kHint, "", report_); }

  private:
    void checkAccessors(const nlohmann::json& source, const SamplerUse& use);
    void takeValues(const nlohmann::json& source, const SamplerUse& use);
    void hintAtAccessors(const nlohmann::json& source);
    void readWeights(std::size_t output, std::size_t targets, AnimationSampler& sampler);
    void settleSwitch(std::size_t output, AnimationSampler& sampler, const Place& place);

    const Import& import_;
    Report& report_;
    std::size_t valuesLeft_ = kMaxAnimationValues;
    Tally hints_;
};

}  // namespace ribalta::gltf
