#include "gltf/mend_light.h"

#include <algorithm>
#include <numbers>
#include <string>

#include "gltf/import.h"
#include "scene/light.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

constexpr double kDefaultOuterAngle = std::numbers::pi / 4.0;

std::string degrees(double radians) {
    const std::string text = std::to_string(radians * 180.0 / std::numbers::pi);
    return text.substr(0, text.find('.') + 2) + " degrees";
}

void mendRange(json& light, const Where& where, Report& report) {
    const json& range = member(light, "range");
    if (range.is_number() && !(range.get<double>() > 0.0)) {
        report.repaired(Where(where, "range").place(),
                        "is " + range.dump() + ", expected more than 0; the range is unlimited");
        light.erase("range");
    }
}

void mendCone(json& light, const Where& where, Report& report) {
    if (!light.contains("spot")) {
        report.repaired(where.place(), "is a spot without \"spot\"; the default cone is used");
        light["spot"] = json::object();
    }
    json& spot = light["spot"];
    const Where here(where, "spot");
    const double outer = spot.value("outerConeAngle", kDefaultOuterAngle);
    const double inner = spot.value("innerConeAngle", 0.0);
    const double drawn = std::clamp(outer, kMinConeAngle, kMaxConeAngle);
    if (drawn != outer) {
        report.repaired(Where(here, "outerConeAngle").place(),
                        "is " + degrees(outer) + ", drawn as " + degrees(drawn) +
                            "; spots are drawn from 0.5 to 80 degrees");
    }
    if (inner >= outer) {
        report.repaired(Where(here, "innerConeAngle").place(),
                        "is " + degrees(inner) +
                            ", expected less than the outer angle; the cone has a hard edge");
    }
    spot["outerConeAngle"] = drawn;
    spot["innerConeAngle"] = std::min(inner, drawn);
}

}  // namespace

void mendLight(json& light, const Where& where, Report& report) {
    mendRange(light, where, report);
    if (light["type"] == "spot") {
        mendCone(light, where, report);
    }
}

}  // namespace ribalta::gltf
