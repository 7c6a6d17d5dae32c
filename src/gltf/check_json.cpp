#include "gltf/check_json.h"

#include <utility>

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
    if (extension(root, kLightsPunctual).is_null()) {
        return;
    }
    const Where extensions(rootWhere, "extensions");
    const Where where(extensions, kLightsPunctual);
    json& holder = root["extensions"][kLightsPunctual];
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

// Skins likewise: a faulty one costs the skin, and its meshes are drawn unskinned.
void checkSkins(json& root, const Where& rootWhere, Report& report) {
    if (!root.contains("skins")) {
        return;
    }
    const Where where(rootWhere, "skins");
    // Taken out while they change: the rules look things up in the rest of the document.
    json skins = std::move(root["skins"]);
    root.erase("skins");
    if (!skins.is_array()) {
        report.ignored(where.place(), std::string("is no list but ") + skins.type_name() +
                                          "; meshes are drawn unskinned");
        return;
    }
    if (skins.empty()) {
        report.hint(where.place(), "is empty; glTF 2.0 asks to leave it out instead");
    }
    for (std::size_t i = 0; i < skins.size(); ++i) {
        const Where here(where, i);
        try {
            if (!skins[i].is_object()) {
                throw JsonFault{here.place(),
                                std::string("is no object but ") + skins[i].type_name()};
            }
            checkMembers(skins[i], skinRules(), here, root, report);
            if (skins[i]["joints"].empty()) {
                throw JsonFault{here.place().at("joints"), "is empty, expected at least one joint"};
            }
        } catch (const JsonFault& fault) {
            report.ignored(fault.place,
                           fault.message + "; the meshes that use this skin are drawn unskinned");
            skins[i] = nullptr;
        }
    }
    root["skins"] = std::move(skins);
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
    checkSkins(root, where, report);
    mendAnimations(root, where, report);
}

}  // namespace ribalta::gltf
