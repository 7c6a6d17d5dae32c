// JsonRule: what one member of a glTF object must look like, as data.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/report.h"
#include "gltf/where.h"

namespace ribalta::gltf {

struct JsonRule {
    enum class Is {
        kNumber,   ///< within low..high
        kInteger,  ///< within low..high, also written as 3.0
        kBool,
        kString,
        kIndex,      ///< an integer that counts into the top-level array `into`
        kIndices,    ///< an array of those
        kIndexMap,   ///< an object whose members are those
        kIndexMaps,  ///< an array of such objects
        kNumbers,    ///< an array of `length` numbers, of any if 0, each within low..high
        kStrings,
        kObject,   ///< checked against `members`
        kObjects,  ///< an array of those
    };
    /// What a fault leads to.
    enum class OnFault {
        kError,   ///< the file is refused
        kRepair,  ///< numbers out of range are clamped, anything else falls back to the default
    };

    std::string_view key;
    Is is = Is::kNumber;
    OnFault onFault = OnFault::kError;
    bool required = false;
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    const char* into = nullptr;
    std::size_t length = 0;
    std::vector<std::string_view> words{};  ///< kString: the only ones allowed, where any
    int multipleOf = 1;                     ///< kInteger
    std::vector<int> values{};              ///< kInteger: the only ones allowed, where any
    std::span<const JsonRule> members{};
};

/// What a document has that cannot be mended where it stands. Thrown; becomes an Error or a line of
/// the report, as the caller decides.
struct JsonFault {
    Place place;
    std::string message;
};

/// Checks and mends the members of `object` that have a rule; others are left alone. `root` is the
/// whole document. Throws JsonFault.
void checkMembers(nlohmann::json& object, std::span<const JsonRule> rules, const Where& where,
                  const nlohmann::json& root, Report& report);

/// The rules of a glTF document, and of the member `KHR_lights_punctual` of its extensions.
std::span<const JsonRule> gltfRules();
std::span<const JsonRule> lightRules();

/// The rules of one skin.
std::span<const JsonRule> skinRules();

/// The rules of what stands in an animation's lists.
std::span<const JsonRule> animationSamplerRules();
std::span<const JsonRule> animationChannelRules();

}  // namespace ribalta::gltf
