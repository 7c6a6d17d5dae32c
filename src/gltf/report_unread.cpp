#include "gltf/report_unread.h"

#include <string>

#include "gltf/check_extensions.h"
#include "gltf/tally.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// JSON is nested at most kMaxNesting deep, so recursion is.
void tallyExtensions(const json& value, const Where& where, Tally& tally) {
    if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (value[i].is_structured()) {
                tallyExtensions(value[i], Where(where, i), tally);
            }
        }
        return;
    }
    for (const auto& [key, child] : value.items()) {
        if (!child.is_structured() || key == "extras") {
            continue;
        }
        const Where here(where, key);
        if (key == "extensions" && child.is_object()) {
            for (const auto& [name, content] : child.items()) {
                if (!isSupported(name)) {
                    tally.add(name, Where(here, name));
                }
            }
        }
        tallyExtensions(child, here, tally);
    }
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
    Tally extensions;
    tallyExtensions(import.json, root, extensions);
    extensions.tell(Report::Kind::kIgnored, " is not supported and left out", report);
}

}  // namespace ribalta::gltf
