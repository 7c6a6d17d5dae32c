#include "gltf/read_attributes.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gltf/bad_input.h"
#include "gltf/decode_draco.h"
#include "gltf/mesh_cache.h"
#include "gltf/read_accessor.h"
#include "gltf/read_buffers.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

constexpr const char* kDraco = "KHR_draco_mesh_compression";

std::optional<std::size_t> accessorOf(const tinygltf::Primitive& source,
                                      const std::string& attribute) {
    const auto found = source.attributes.find(attribute);
    return found == source.attributes.end() ? std::nullopt
                                            : std::optional(std::size_t(found->second));
}

// Some graphics interfaces end a strip at the largest index of a type; glTF forbids its use.
void reportPrimitiveRestart(const tinygltf::Accessor& accessor,
                            const std::vector<std::uint32_t>& indices, const Place& place,
                            Report& report) {
    const std::uint32_t restart =
        accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 0xFFU
        : accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 0xFFFFU
                                                                           : 0xFFFFFFFFU;
    const auto found = std::find(indices.begin(), indices.end(), restart);
    if (found != indices.end()) {
        report.repaired(place.at("indices"),
                        "element " + std::to_string(found - indices.begin()) + " is " +
                            std::to_string(restart) +
                            ", the primitive restart value, which glTF 2.0 forbids; it is drawn "
                            "as a vertex");
    }
}

void readFromAccessors(const Import& import, const tinygltf::Primitive& source, const Place& place,
                       Primitive& target, Report& report) {
    const auto read = [&](const char* attribute, auto& array, auto reader) {
        if (const auto accessor = accessorOf(source, attribute)) {
            array = reader(import, *accessor);
        }
    };
    read("POSITION", target.positions, readVec3);
    read("NORMAL", target.normals, readVec3);
    read("TANGENT", target.tangents, readVec4);
    read("TEXCOORD_0", target.uv0, readVec2);
    read("TEXCOORD_1", target.uv1, readVec2);
    read("COLOR_0", target.colors, readColors);
    if (source.indices >= 0) {
        const auto accessor = std::size_t(source.indices);
        target.indices = readIndices(import, accessor);
        reportPrimitiveRestart(import.model.accessors[accessor], target.indices, place, report);
    } else {
        target.indices.resize(target.positions.size());
        std::iota(target.indices.begin(), target.indices.end(), 0U);
    }
}

template <int N>
void take(const DracoAttribute& attribute, std::vector<glm::vec<N, float>>& target) {
    const auto components = std::size_t(attribute.components);
    const std::size_t count = attribute.values.size() / components;
    target.assign(count, glm::vec<N, float>(1.0F));
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t c = 0; c < std::min(components, std::size_t(N)); ++c) {
            target[i][int(c)] = attribute.values[i * components + c];
        }
    }
}

// The attributes of a Draco extension that are drawn, and their names.
struct DracoWishes {
    std::vector<DracoRequest> requests;
    std::vector<std::string> names;
};

DracoWishes readDracoWishes(const Import& import, const tinygltf::Primitive& source,
                            const json& ids, bool withJoints, const Place& place, Report& report) {
    std::vector<std::pair<std::string, int>> wanted = {{"POSITION", 3},   {"NORMAL", 3},
                                                       {"TANGENT", 4},    {"TEXCOORD_0", 2},
                                                       {"TEXCOORD_1", 2}, {"COLOR_0", 3}};
    const auto isThere = [&](const std::string& name) {
        return ids.contains(name) && source.attributes.contains(name);
    };
    for (std::size_t n = 0; withJoints && isThere("JOINTS_" + std::to_string(n)) &&
                            isThere("WEIGHTS_" + std::to_string(n));
         ++n) {
        wanted.emplace_back("JOINTS_" + std::to_string(n), 4);
        wanted.emplace_back("WEIGHTS_" + std::to_string(n), 4);
    }
    for (const auto& [name, id] : ids.items()) {
        if (!source.attributes.contains(name)) {
            report.ignored(place.at("attributes").at(name),
                           "is not among the primitive's own attributes; it is not drawn");
        }
    }
    DracoWishes wishes;
    for (const auto& [name, components] : wanted) {
        const auto id = ids.find(name);
        if (id == ids.end()) {
            continue;
        }
        const Place here = place.at("attributes").at(name);
        const auto accessor = accessorOf(source, name);
        if (!accessor) {
            continue;
        }
        if (!id->is_number_integer() || *id < 0 || *id > 0xFFFFFFFFLL) {
            badInput(here, "is " + id->dump() + ", no attribute id; export the mesh again");
        }
        wishes.requests.push_back({id->get<std::uint32_t>(), components,
                                   import.model.accessors[*accessor].normalized, here});
        wishes.names.emplace_back(name);
    }
    return wishes;
}

void reportCount(std::size_t decoded, int accessor, const Import& import, const char* what,
                 const Place& place, Report& report) {
    if (accessor < 0) {
        return;
    }
    const std::size_t promised = import.model.accessors[std::size_t(accessor)].count;
    if (promised != decoded) {
        report.repaired(place, "decodes to " + std::to_string(decoded) + " " + what +
                                   ", accessor " + std::to_string(accessor) + " promises " +
                                   std::to_string(promised) + "; what was decoded is drawn");
    }
}

void reportAccessorOffsets(const Import& import, const tinygltf::Primitive& source,
                           Report& report) {
    for (const auto& [name, index] : source.attributes) {
        if (import.model.accessors[std::size_t(index)].byteOffset != 0) {
            report.repaired(import.file.at("accessors").at(std::size_t(index)).at("byteOffset"),
                            "has no meaning for Draco data and is not used");
        }
    }
}

void readFromDraco(const Import& import, const tinygltf::Primitive& source, const json& draco,
                   const Place& place, Primitive& target, std::vector<JointSet>* joints,
                   Report& report) {
    const json& view = member(draco, "bufferView");
    const json& ids = member(draco, "attributes");
    if (!view.is_number_integer() || view < 0 || view >= import.model.bufferViews.size()) {
        badInput(place, "lacks the index of a bufferView of the file; export the mesh again");
    }
    if (!ids.is_object()) {
        badInput(place, "lacks its attributes; export the mesh again");
    }
    const DracoWishes wishes =
        readDracoWishes(import, source, ids, joints != nullptr, place, report);
    const std::size_t expectedFaces =
        source.indices >= 0 ? import.model.accessors[std::size_t(source.indices)].count / 3 : 0;
    DracoMesh mesh =
        import.meshCache->decode(copyOfView(import, view.get<std::size_t>()), wishes.requests,
                                 expectedFaces, *import.budget, place);
    for (std::size_t i = 0; i < wishes.names.size(); ++i) {
        const std::string& name = wishes.names[i];
        const DracoAttribute& attribute = mesh.attributes[i];
        if (name == "POSITION") {
            take(attribute, target.positions);
        } else if (name == "NORMAL") {
            take(attribute, target.normals);
        } else if (name == "TANGENT") {
            take(attribute, target.tangents);
        } else if (name == "TEXCOORD_0") {
            take(attribute, target.uv0);
        } else if (name == "TEXCOORD_1") {
            take(attribute, target.uv1);
        } else if (name == "COLOR_0") {
            take(attribute, target.colors);
        } else if (name.starts_with("JOINTS_")) {
            take(attribute, joints->emplace_back().joints);
        } else {
            take(attribute, joints->back().weights);  // which follow their joints
        }
    }
    target.indices = std::move(mesh.indices);
    const auto positions = accessorOf(source, "POSITION");
    reportCount(mesh.vertices, positions ? int(*positions) : -1, import, "vertices", place, report);
    if (source.mode == TINYGLTF_MODE_TRIANGLES) {
        reportCount(target.indices.size(), source.indices, import, "indices", place, report);
    }
    reportAccessorOffsets(import, source, report);
}

}  // namespace

int readAttributes(const Import& import, const tinygltf::Primitive& source, const json& object,
                   const Place& place, Primitive& target, std::vector<JointSet>* joints,
                   Report& report) {
    const json& draco = extension(object, kDraco);
    if (draco.is_null()) {
        readFromAccessors(import, source, place, target, report);
        if (joints != nullptr) {
            *joints = readJointSets(import, source, place, report);
        }
        return source.mode;
    }
    readFromDraco(import, source, draco, place.at("extensions").at(kDraco), target, joints, report);
    return TINYGLTF_MODE_TRIANGLES;
}

}  // namespace ribalta::gltf
