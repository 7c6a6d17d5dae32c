#include "gltf/choose_variant.h"

#include "gltf/find_named.h"
#include "gltf/import.h"
#include "gltf/json_rules.h"
#include "gltf/tally.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

constexpr const char* kVariants = "KHR_materials_variants";

const JsonRule kMappingRules[] = {
    {.key = "material", .is = JsonRule::Is::kIndex, .required = true, .into = "materials"},
};

std::vector<std::string> namesOf(const json& root, const Place& file, Report& report) {
    const json& object = extension(root, kVariants);
    std::vector<std::string> names;
    if (object.is_null()) {
        return names;
    }
    const Place place = file.at("extensions").at(kVariants);
    const json& list = member(object, "variants");
    if (!list.is_array()) {
        report.ignored(place, "has no list of variants; the default materials are drawn");
        return names;
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        const json& name = member(list[i], "name");
        if (!name.is_string()) {
            report.repaired(place.at("variants").at(i),
                            "has no name; it is called '" + std::to_string(i) + "'");
        }
        names.push_back(name.is_string() ? name.get<std::string>() : std::to_string(i));
    }
    return names;
}

// A primitive's mappings: every one is looked at, so that what is said of a file does not depend on
// the choice.
class Mappings {
  public:
    Mappings(const json& root, std::size_t variants, std::optional<std::size_t> chosen,
             Report& report)
        : root_(root), variants_(variants), chosen_(chosen), report_(report) {}

    /// The material that the chosen variant has for a primitive.
    std::optional<json> materialOf(const json& object, const Where& where) {
        const json& mappings = member(object, "mappings");
        if (!mappings.is_array()) {
            report_.ignored(where.place(), "has no list of mappings; its material is the default");
            return std::nullopt;
        }
        std::vector<char> seen(variants_, 0);
        std::optional<json> material;
        const Where list(where, "mappings");
        for (std::size_t i = 0; i < mappings.size(); ++i) {
            const Where here(list, i);
            json mapping = mappings[i];
            if (isReadable(mapping, here) && isOfChosen(mapping, here, seen)) {
                material = mapping["material"];
            }
        }
        return material;
    }

  private:
    bool isReadable(json& mapping, const Where& here) {
        try {
            if (!mapping.is_object()) {
                throw JsonFault{here.place(),
                                std::string("is no object but ") + mapping.type_name()};
            }
            checkMembers(mapping, kMappingRules, here, root_, report_);
            if (!member(mapping, "variants").is_array()) {
                throw JsonFault{here.place(), "has no list of variants"};
            }
        } catch (const JsonFault& fault) {
            report_.ignored(fault.place, fault.message + "; the mapping is left out");
            return false;
        }
        return true;
    }

    bool isOfChosen(const json& mapping, const Where& here, std::vector<char>& seen) {
        bool isChosen = false;
        const json& list = mapping["variants"];
        const Where where(here, "variants");
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Where at(where, i);
            if (!list[i].is_number_integer() || list[i] < 0 || list[i] >= variants_) {
                report_.ignored(at.place(), "is " + list[i].dump() + ", but the file has " +
                                                counted(variants_, "variants"));
                continue;
            }
            const auto variant = list[i].get<std::size_t>();
            if (seen[variant] != 0) {
                report_.ignored(at.place(), "has variant " + std::to_string(variant) +
                                                " again, which an earlier mapping has; that is "
                                                "used");
                continue;
            }
            seen[variant] = 1;
            isChosen = isChosen || chosen_ == variant;
        }
        return isChosen;
    }

    const json& root_;
    std::size_t variants_;
    std::optional<std::size_t> chosen_;
    Report& report_;
};

}  // namespace

std::vector<std::string> chooseVariant(json& root, const std::optional<std::string>& nameOrIndex,
                                       const Place& file, Report& report) {
    std::vector<std::string> names = namesOf(root, file, report);
    std::optional<std::size_t> chosen;
    if (nameOrIndex) {
        chosen = findNamed(names, *nameOrIndex, "variant", "it has none at all", file);
    }
    Mappings mappings(root, names.size(), chosen, report);
    const Where rootWhere(file);
    const Where meshesWhere(rootWhere, "meshes");
    const std::size_t meshes = member(root, "meshes").size();
    for (std::size_t m = 0; m < meshes; ++m) {
        json& primitives = root["meshes"][m]["primitives"];
        const Where mesh(meshesWhere, m);
        const Where list(mesh, "primitives");
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            const json& object = extension(primitives[p], kVariants);
            if (object.is_null()) {
                continue;
            }
            const Where primitive(list, p);
            const Where extensions(primitive, "extensions");
            if (const auto material = mappings.materialOf(object, Where(extensions, kVariants))) {
                primitives[p]["material"] = *material;
            }
        }
    }
    return names;
}

}  // namespace ribalta::gltf
