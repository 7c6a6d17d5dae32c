#include "gltf/animation_pointer.h"

#include <algorithm>
#include <charconv>

namespace ribalta::gltf {
namespace {

using Owner = PointedAt::Owner;
using Part = AnimationChannel::Part;
using Numbers = Dial::Numbers;
using Values = SamplerUse::Values;

constexpr std::size_t kLongestShown = 100;

struct Row {
    std::string_view list;
    std::string_view property;
    PointedAt at;
};

constexpr std::string_view kNodes = "/nodes/";
constexpr std::string_view kLights = "/extensions/KHR_lights_punctual/lights/";
constexpr std::string_view kCameras = "/cameras/";
constexpr std::string_view kMaterials = "/materials/";

constexpr PointedAt ofNode(Part part, Values values) {
    return {Owner::kNode, 0, part, Numbers::kVisible, 0, 0, values};
}

constexpr PointedAt dial(Owner owner, Numbers numbers, int first = 0, int count = 1,
                         Values values = Values::kNumber) {
    return {owner, 0, Part::kDial, numbers, first, count, values};
}

// By the glTF 2.0 Asset Object Model.
constexpr Row kRows[] = {
    {kNodes, "/translation", ofNode(Part::kTranslation, Values::kVec3)},
    {kNodes, "/rotation", ofNode(Part::kRotation, Values::kRotation)},
    {kNodes, "/scale", ofNode(Part::kScale, Values::kVec3)},
    {kNodes, "/weights", ofNode(Part::kWeights, Values::kWeights)},
    {kNodes, "/extensions/KHR_node_visibility/visible",
     dial(Owner::kNode, Numbers::kVisible, 0, 1, Values::kSwitch)},
    {kLights, "/color", dial(Owner::kLight, Numbers::kColor, 0, 3, Values::kVec3)},
    {kLights, "/intensity", dial(Owner::kLight, Numbers::kIntensity)},
    {kLights, "/range", dial(Owner::kLight, Numbers::kRange)},
    {kLights, "/spot/innerConeAngle", dial(Owner::kLight, Numbers::kCone, 0)},
    {kLights, "/spot/outerConeAngle", dial(Owner::kLight, Numbers::kCone, 1)},
    {kCameras, "/perspective/yfov", dial(Owner::kCamera, Numbers::kFov)},
    {kCameras, "/perspective/aspectRatio", dial(Owner::kCamera, Numbers::kAspect)},
    {kCameras, "/perspective/znear", dial(Owner::kCamera, Numbers::kDepth, 0)},
    {kCameras, "/perspective/zfar", dial(Owner::kCamera, Numbers::kDepth, 1)},
    {kCameras, "/orthographic/xmag", dial(Owner::kCamera, Numbers::kExtent, 0)},
    {kCameras, "/orthographic/ymag", dial(Owner::kCamera, Numbers::kExtent, 1)},
    {kCameras, "/orthographic/znear", dial(Owner::kCamera, Numbers::kBoxDepth, 0)},
    {kCameras, "/orthographic/zfar", dial(Owner::kCamera, Numbers::kBoxDepth, 1)},
    {kMaterials, "/pbrMetallicRoughness/baseColorFactor",
     dial(Owner::kMaterial, Numbers::kBaseColor, 0, 4, Values::kVec4)},
    {kMaterials, "/emissiveFactor",
     dial(Owner::kMaterial, Numbers::kEmission, 0, 3, Values::kVec3)},
    {kMaterials, "/extensions/KHR_materials_emissive_strength/emissiveStrength",
     dial(Owner::kMaterial, Numbers::kEmission, 3)},
};

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

// RFC 6901: digits without a leading zero.
std::optional<std::size_t> indexOf(std::string_view digits) {
    std::size_t index = 0;
    const char* end = digits.data() + digits.size();
    const bool isPlain = std::all_of(digits.begin(), digits.end(), isDigit) &&
                         (digits.size() == 1 || digits[0] != '0');
    if (digits.empty() || !isPlain) {
        return std::nullopt;
    }
    const auto [stop, fault] = std::from_chars(digits.data(), end, index);
    return fault == std::errc() && stop == end ? std::optional(index) : std::nullopt;
}

}  // namespace

std::optional<PointedAt> parsePointer(std::string_view pointer) {
    for (const Row& row : kRows) {
        if (!pointer.starts_with(row.list)) {
            continue;
        }
        const std::string_view rest = pointer.substr(row.list.size());
        const std::size_t slash = rest.find('/');
        if (slash == std::string_view::npos || rest.substr(slash) != row.property) {
            continue;
        }
        if (const std::optional<std::size_t> index = indexOf(rest.substr(0, slash))) {
            PointedAt at = row.at;
            at.index = *index;
            return at;
        }
    }
    return std::nullopt;
}

std::string withoutIndices(std::string_view pointer) {
    std::string text;
    for (std::size_t i = 0; i < pointer.size() && text.size() < kLongestShown; ++i) {
        text += pointer[i];
        std::size_t end = i + 1;
        while (end < pointer.size() && isDigit(pointer[end])) {
            ++end;
        }
        if (pointer[i] == '/' && end > i + 1 && (end == pointer.size() || pointer[end] == '/')) {
            text += "{}";
            i = end - 1;
        }
    }
    return text.size() < kLongestShown ? text : text + "...";
}

}  // namespace ribalta::gltf
