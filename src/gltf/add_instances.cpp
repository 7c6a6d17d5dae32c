#include "gltf/add_instances.h"

#include <cmath>
#include <optional>
#include <string>

#include "gltf/bad_input.h"
#include "gltf/read_accessor.h"
#include "gltf/tally.h"
#include "gltf/where.h"
#include "scene/pose.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";
// Largest number of an instance's placement: with it no product with a node's overflows.
constexpr double kMaxInstanceNumber = 1e8;

// The three attributes of a node's instances; those that the file leaves out are empty.
struct Attributes {
    std::size_t count = 0;
    std::vector<glm::vec3> translations;
    std::vector<glm::vec4> rotations;
    std::vector<glm::vec3> scales;
};

std::optional<std::size_t> accessorOf(const Import& import, const json& attributes,
                                      const char* name, const Place& place) {
    const json& index = member(attributes, name);
    if (index.is_null()) {
        return std::nullopt;
    }
    if (!index.is_number_integer() || index < 0 || index >= import.model.accessors.size()) {
        badInput(place.at(name), "is " + index.dump() + ", but the file has " +
                                     counted(import.model.accessors.size(), "accessors"));
    }
    return index.get<std::size_t>();
}

// Throws Error(kBadInput). `left` is how many instances the scene may still have.
Attributes readInstanceAttributes(const Import& import, const json& object, std::size_t left,
                                  const Place& place) {
    const json& attributes = member(object, "attributes");
    if (!attributes.is_object() || attributes.empty()) {
        badInput(place, "has no attributes");
    }
    const Place here = place.at("attributes");
    Attributes read;
    std::string first;
    for (const auto& [name, index] : attributes.items()) {
        const auto accessor = accessorOf(import, attributes, name.c_str(), here);
        if (!accessor) {
            continue;
        }
        const std::size_t count = import.model.accessors[*accessor].count;
        if (!first.empty() && count != read.count) {
            badInput(here.at(name), "has " + counted(count, "elements") + ", " + first + " has " +
                                        std::to_string(read.count));
        }
        first = name;
        read.count = count;
    }
    import.budget->takeNodes(read.count, here);
    if (read.count > left) {
        badInput(here, "with these the scene has over " + std::to_string(kMaxInstances) +
                           " instances, the most that are drawn; split the scene");
    }
    if (const auto accessor = accessorOf(import, attributes, "TRANSLATION", here)) {
        read.translations = readVec3(import, *accessor);
    }
    if (const auto accessor = accessorOf(import, attributes, "ROTATION", here)) {
        read.rotations = readVec4(import, *accessor);
    }
    if (const auto accessor = accessorOf(import, attributes, "SCALE", here)) {
        read.scales = readVec3(import, *accessor);
    }
    return read;
}

bool isUsable(const Pose& pose) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(pose.translation[axis]) <= kMaxInstanceNumber) ||
            !(std::abs(pose.scale[axis]) <= kMaxInstanceNumber)) {
            return false;
        }
    }
    const double length = glm::length(pose.rotation);
    return std::isfinite(length) && length > 1e-6;
}

// Where instance i stands; nothing where its numbers are of no use.
std::optional<glm::dmat4> placeOf(const Attributes& attributes, std::size_t i) {
    Pose pose;
    if (!attributes.translations.empty()) {
        pose.translation = glm::dvec3(attributes.translations[i]);
    }
    if (!attributes.rotations.empty()) {
        const glm::dvec4 turn(attributes.rotations[i]);
        pose.rotation = glm::dquat(turn.w, turn.x, turn.y, turn.z);
    }
    if (!attributes.scales.empty()) {
        pose.scale = glm::dvec3(attributes.scales[i]);
    }
    if (!isUsable(pose)) {
        return std::nullopt;
    }
    pose.rotation = glm::normalize(pose.rotation);
    return pose.parentFromLocal();
}

void tellOfCustom(const json& object, const Where& where, Tally& tally) {
    const Where attributes(where, "attributes");
    for (const auto& [name, index] : member(object, "attributes").items()) {
        if (name != "TRANSLATION" && name != "ROTATION" && name != "SCALE") {
            tally.add("an instance's " + name, Where(attributes, name));
        }
    }
}

// Adds the instances of node `parent` of the list. Returns how many there are.
std::size_t addTo(NodeList& list, std::size_t parent, const Attributes& attributes,
                  const Place& place, Report& report) {
    const int mesh = list.nodes[parent].mesh;
    list.nodes[parent].mesh = -1;
    list.nodes.reserve(list.nodes.size() + attributes.count);
    std::size_t useless = 0;
    std::size_t vanished = 0;
    for (std::size_t i = 0; i < attributes.count; ++i) {
        const std::optional<glm::dmat4> parentFromLocal = placeOf(attributes, i);
        if (!parentFromLocal) {
            ++useless;
        } else if (vanishes(*parentFromLocal)) {
            ++vanished;
        } else {
            Node node;
            node.parent = int(parent);
            node.parentFromLocal = *parentFromLocal;
            node.mesh = mesh;
            list.nodes.push_back(std::move(node));
        }
    }
    const auto tell = [&](std::size_t count, const char* why) {
        if (count > 0) {
            report.ignored(place, counted(count, "instances") + " of " +
                                      std::to_string(attributes.count) + " " + why +
                                      " and left out");
        }
    };
    tell(useless, "placed by numbers that are not finite, out of all bounds or no rotation,");
    tell(vanished, "scaled to nothing");
    return attributes.count;
}

}  // namespace

void addInstances(const Import& import, NodeList& list, Report& report) {
    const Where root(import.file);
    const Where nodes(root, "nodes");
    Tally custom;
    std::size_t taken = 0;
    // Skinned meshes, which stand behind the scene's own nodes, are placed by their joints alone.
    for (std::size_t i = 0; i < list.inScene; ++i) {
        const json& object = import.nodes[list.gltfNodes[i]].extension(kInstancing);
        if (object.is_null() || list.nodes[i].mesh < 0) {
            continue;
        }
        const Where node(nodes, list.gltfNodes[i]);
        const Where extensions(node, "extensions");
        const Where where(extensions, kInstancing);
        const Place place = where.place();
        if (list.nodes[i].deformer >= 0) {
            report.ignored(place,
                           "is of a mesh with morph targets, which is drawn once, at its node");
            continue;
        }
        try {
            const Attributes attributes =
                readInstanceAttributes(import, object, kMaxInstances - taken, place);
            tellOfCustom(object, where, custom);
            taken += addTo(list, i, attributes, place, report);
        } catch (const Error& error) {
            report.ignored(error.place(),
                           reasonOf(error) + "; the mesh is drawn once, at its node");
        }
    }
    custom.tell(Report::Kind::kIgnored, " is not used", report);
}

}  // namespace ribalta::gltf
