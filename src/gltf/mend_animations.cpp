#include "gltf/mend_animations.h"

#include <span>
#include <string>

#include "gltf/import.h"
#include "gltf/json_rules.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// What becomes of a list's faulty elements, for the report.
struct Fate {
    const char* thing;
    const char* lost;
};

// Puts null in the place of every element that breaks a rule.
void mendList(json& list, std::span<const JsonRule> rules, const Fate& fate, const Where& where,
              const json& root, Report& report) {
    if (list.empty()) {
        report.hint(where.place(), "is empty; an animation without it moves nothing");
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Where here(where, i);
        try {
            if (!list[i].is_object()) {
                throw JsonFault{here.place(), std::string("is no object but ") +
                                                  list[i].type_name() + ", and no " + fate.thing};
            }
            checkMembers(list[i], rules, here, root, report);
        } catch (const JsonFault& fault) {
            report.ignored(fault.place, fault.message + "; " + fate.lost);
            list[i] = nullptr;
        }
    }
}

void mendAnimation(json& animation, const Where& where, const json& root, Report& report) {
    if (!animation.is_object()) {
        report.ignored(where.place(), std::string("is no object but ") + animation.type_name() +
                                          "; it is not played");
        animation = nullptr;
        return;
    }
    for (const char* key : {"samplers", "channels"}) {
        if (!member(animation, key).is_array()) {
            report.ignored(where.place(), std::string("has no list of ") + key +
                                              ", which glTF 2.0 requires; it is not played");
            animation = nullptr;
            return;
        }
    }
    mendList(animation["samplers"], animationSamplerRules(),
             {"sampler", "the channels that use this sampler are left out"},
             Where(where, "samplers"), root, report);
    mendList(animation["channels"], animationChannelRules(), {"channel", "the channel is left out"},
             Where(where, "channels"), root, report);
}

}  // namespace

void mendAnimations(json& root, const Where& rootWhere, Report& report) {
    if (!root.contains("animations")) {
        return;
    }
    const Where where(rootWhere, "animations");
    if (!root["animations"].is_array()) {
        report.ignored(where.place(), std::string("is no list but ") +
                                          root["animations"].type_name() +
                                          "; the scene is drawn as it stands");
        root.erase("animations");
        return;
    }
    // Taken out while they change: the rules look things up in the rest of the document.
    json animations = std::move(root["animations"]);
    if (animations.empty()) {
        report.hint(where.place(), "is empty; glTF 2.0 asks to leave it out instead");
    }
    for (std::size_t i = 0; i < animations.size(); ++i) {
        mendAnimation(animations[i], Where(where, i), root, report);
    }
    root["animations"] = std::move(animations);
}

}  // namespace ribalta::gltf
