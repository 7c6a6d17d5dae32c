#include "gltf/check_json.h"

#include "gltf/bad_input.h"
#include "gltf/import.h"
#include "gltf/json_rules.h"
#include "gltf/mend_animations.h"
#include "gltf/mend_light.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// Lights are values on top of the scene: a faulty one costs that lamp, not the file.
void checkLights(json& root, const Where& rootWhere, Report& report) {
    if (extension(root, "KHR_lights_punctual").is_null()) {
        return;
    }
    const Where extensions(rootWhere, "extensions");
    const Where where(extensions, "KHR_lights_punctual");
    json& holder = root["extensions"]["KHR_lights_punctual"];
    if (!member(holder, "lights").is_array() || holder["lights"].empty()) {
        report.repaired(where.place(), "has no list of lights; read as one without lights");
        holder = {{"lights", json::array()}};
        return;
    }
    const Where lights(where, "lights");
    for (std::size_t i = 0; i < holder["lights"].size(); ++i) {
        json& light = holder["lights"][i];
        const Where here(lights, i);
        if (!light.is_object()) {
            report.ignored(here.place(), "is no object but " + std::string(light.type_name()) +
                                             "; the lamps that use it are left out");
            light = nullptr;
            continue;
        }
        try {
            checkMembers(light, lightRules(), here, root, report);
            mendLight(light, here, report);
        } catch (const JsonFault& fault) {
            report.ignored(fault.place,
                           fault.message + "; the lamps that use this light are left out");
            light = nullptr;
        }
    }
}

}  // namespace

void checkJson(json& root, const Place& file, Report& report) {
    const Where where(file);
    try {
        checkMembers(root, gltfRules(), where, root, report);
    } catch (const JsonFault& fault) {
        badInput(fault.place, fault.message + "; export the file again or mend it there");
    }
    checkLights(root, where, report);
    mendAnimations(root, where, report);
}

}  // namespace ribalta::gltf
