#include "gltf/report_unread.h"

#include <set>
#include <string>

#include "gltf/check_extensions.h"
#include "gltf/tally.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

struct ExtensionTallies {
    Tally unsupported;
    Tally undeclared;
    std::set<std::string> declared;
};

// JSON is nested at most kMaxNesting deep, so recursion is.
void tallyExtensions(const json& value, const Where& where, ExtensionTallies& tallies) {
    if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (value[i].is_structured()) {
                tallyExtensions(value[i], Where(where, i), tallies);
            }
        }
        return;
    }
    for (const auto& [key, child] : value.get_ref<const json::object_t&>()) {
        if (!child.is_structured() || key == "extras") {
            continue;
        }
        const Where here(where, key);
        if (key == "extensions" && child.is_object()) {
            for (const auto& [name, content] : child.items()) {
                if (!isSupported(name)) {
                    tallies.unsupported.add(name, Where(here, name));
                } else if (!tallies.declared.contains(name)) {
                    tallies.undeclared.add(name, Where(here, name));
                }
            }
        }
        tallyExtensions(child, here, tallies);
    }
}

std::set<std::string> namesIn(const json& list) {
    std::set<std::string> names;
    for (std::size_t i = 0; list.is_array() && i < list.size(); ++i) {
        if (list[i].is_string()) {
            names.insert(list[i].get<std::string>());
        }
    }
    return names;
}

bool isRead(const std::string& attribute) {
    return attribute == "POSITION" || attribute == "NORMAL" || attribute == "TANGENT" ||
           attribute == "TEXCOORD_0" || attribute == "TEXCOORD_1" || attribute == "COLOR_0" ||
           // Told with their skins, where they are used.
           attribute.starts_with("JOINTS_") || attribute.starts_with("WEIGHTS_");
}

void tallyPrimitives(const json& root, const Where& rootWhere, Tally& attributes) {
    const json& meshes = member(root, "meshes");
    const Where meshesWhere(rootWhere, "meshes");
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const Where meshWhere(meshesWhere, m);
        const Where listWhere(meshWhere, "primitives");
        const json& primitives = meshes[m]["primitives"];
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            const Where where(listWhere, p);
            const Where attributesWhere(where, "attributes");
            for (const auto& [name, accessor] : primitives[p]["attributes"].items()) {
                if (!isRead(name)) {
                    attributes.add(name, Where(attributesWhere, name));
                }
            }
        }
    }
}

}  // namespace

void reportUnread(const Import& import, Report& report) {
    const Where root(import.file);
    Tally attributes;
    tallyPrimitives(import.json, root, attributes);
    attributes.tell(Report::Kind::kIgnored, " is not drawn", report);
    ExtensionTallies extensions;
    extensions.declared = namesIn(member(import.json, "extensionsUsed"));
    for (const std::string& name : namesIn(member(import.json, "extensionsRequired"))) {
        if (!extensions.declared.contains(name)) {
            extensions.undeclared.add(name, Where(root, "extensionsRequired"));
        }
    }
    tallyExtensions(import.json, root, extensions);
    extensions.unsupported.tell(Report::Kind::kIgnored, " is not supported and left out", report);
    extensions.undeclared.tell(Report::Kind::kHint,
                               " is missing in extensionsUsed; it is read all the same", report);
}

}  // namespace ribalta::gltf
