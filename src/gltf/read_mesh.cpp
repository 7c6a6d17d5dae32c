#include "gltf/read_mesh.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/parallel_for.h"
#include "base/progress.h"
#include "gltf/bad_input.h"
#include "gltf/decode_draco.h"
#include "gltf/make_normals.h"
#include "gltf/make_tangents.h"
#include "gltf/make_topology.h"
#include "gltf/read_accessor.h"
#include "gltf/read_buffers.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// What one thread turns one glTF primitive into.
struct Job {
    std::size_t mesh = 0;       // into the file's meshes
    std::size_t primitive = 0;  // of that mesh
    std::optional<Primitive> result;
    Report report;
};

std::optional<std::size_t> accessorOf(const tinygltf::Primitive& source, const char* attribute) {
    const auto found = source.attributes.find(attribute);
    return found == source.attributes.end() ? std::nullopt
                                            : std::optional(std::size_t(found->second));
}

// Vertices and indices as the file has them, before anything is made or mended.
struct RawPrimitive {
    Primitive primitive;
    bool hasIndices = false;
    bool isTriangleList = false;  // whatever the mode says: from Draco
};

void readPlainAttributes(const Import& import, const tinygltf::Primitive& source,
                         Primitive& target) {
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
}

template <int N>
void takeVectors(const DracoAttribute& attribute, std::vector<glm::vec<N, float>>& target) {
    const auto components = std::size_t(attribute.components);
    const std::size_t count = attribute.values.size() / components;
    target.assign(count, glm::vec<N, float>(1.0F));
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t c = 0; c < std::min(components, std::size_t(N)); ++c) {
            target[i][int(c)] = attribute.values[i * components + c];
        }
    }
}

RawPrimitive readDracoPrimitive(const Import& import, const tinygltf::Primitive& source,
                                const json& draco, const Place& place) {
    const json& view = member(draco, "bufferView");
    const json& ids = member(draco, "attributes");
    if (!view.is_number_integer() || view < 0 || view >= import.model.bufferViews.size()) {
        badInput(place, "lacks the index of a bufferView of the file; export the mesh again");
    }
    if (!ids.is_object()) {
        badInput(place, "lacks its attributes; export the mesh again");
    }
    RawPrimitive raw;
    std::vector<DracoRequest> requests;
    std::vector<std::string> names;
    const std::pair<const char*, int> wanted[] = {{"POSITION", 3},   {"NORMAL", 3},
                                                  {"TANGENT", 4},    {"TEXCOORD_0", 2},
                                                  {"TEXCOORD_1", 2}, {"COLOR_0", 3}};
    for (const auto& [name, components] : wanted) {
        const auto id = ids.find(name);
        const auto accessor = accessorOf(source, name);
        if (id == ids.end() || !accessor) {
            continue;
        }
        if (!id->is_number_integer() || *id < 0 || *id > 0xFFFFFFFFLL) {
            badInput(place.at("attributes").at(name), "is no attribute id; export the mesh again");
        }
        requests.push_back({id->get<std::uint32_t>(), components,
                            import.model.accessors[*accessor].normalized,
                            place.at("attributes").at(name)});
        names.emplace_back(name);
    }
    const std::size_t expectedFaces =
        source.indices >= 0 ? import.model.accessors[std::size_t(source.indices)].count / 3 : 0;
    DracoMesh mesh =
        decodeDraco(viewBytes(import, view.get<std::size_t>()), requests, expectedFaces, place);
    Primitive& target = raw.primitive;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const DracoAttribute& attribute = mesh.attributes[i];
        if (names[i] == "POSITION") {
            takeVectors(attribute, target.positions);
        } else if (names[i] == "NORMAL") {
            takeVectors(attribute, target.normals);
        } else if (names[i] == "TANGENT") {
            takeVectors(attribute, target.tangents);
        } else if (names[i] == "TEXCOORD_0") {
            takeVectors(attribute, target.uv0);
        } else if (names[i] == "TEXCOORD_1") {
            takeVectors(attribute, target.uv1);
        } else {
            takeVectors(attribute, target.colors);
        }
    }
    target.indices = std::move(mesh.indices);
    raw.hasIndices = true;
    raw.isTriangleList = true;
    return raw;
}

// An optional attribute that does not fit is left out; the rest can be drawn.
template <typename T>
void dropMisfit(std::vector<T>& values, std::size_t count, const char* name, const Place& place,
                Report& report) {
    if (values.empty() || values.size() == count) {
        return;
    }
    report.repaired(place.at("attributes").at(name), "has " + std::to_string(values.size()) +
                                                         " elements for " + std::to_string(count) +
                                                         " vertices; it is left out");
    values.clear();
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <typename T>
std::size_t replaceNonFinite(std::vector<T>& values, const T& replacement) {
    std::size_t replaced = 0;
    for (T& value : values) {
        bool finite = true;
        for (int c = 0; c < T::length(); ++c) {
            finite = finite && std::isfinite(value[c]);
        }
        if (!finite) {
            value = replacement;
            ++replaced;
        }
    }
    return replaced;
}

void mendAttributes(Primitive& primitive, const Place& place, Report& report) {
    const std::size_t count = primitive.positions.size();
    dropMisfit(primitive.normals, count, "NORMAL", place, report);
    dropMisfit(primitive.tangents, count, "TANGENT", place, report);
    dropMisfit(primitive.uv0, count, "TEXCOORD_0", place, report);
    dropMisfit(primitive.uv1, count, "TEXCOORD_1", place, report);
    dropMisfit(primitive.colors, count, "COLOR_0", place, report);
    const auto tell = [&](std::size_t replaced, const char* name, const char* by) {
        if (replaced > 0) {
            report.repaired(
                place.at("attributes").at(name),
                std::to_string(replaced) + " elements are not finite numbers; " + by + " is used");
        }
    };
    tell(replaceNonFinite(primitive.uv0, glm::vec2(0.0F)), "TEXCOORD_0", "0");
    tell(replaceNonFinite(primitive.uv1, glm::vec2(0.0F)), "TEXCOORD_1", "0");
    tell(replaceNonFinite(primitive.colors, glm::vec4(1.0F)), "COLOR_0", "white");
    for (glm::vec4& color : primitive.colors) {
        color = glm::clamp(color, glm::vec4(0.0F), glm::vec4(1.0F));
    }
}

// Takes out triangles (lines, points) with a corner that is not a finite place.
void dropNonFinite(Primitive& primitive, const Place& place, Report& report) {
    std::vector<char> broken(primitive.positions.size(), 0);
    bool any = false;
    for (std::size_t i = 0; i < broken.size(); ++i) {
        if (!isFinite(primitive.positions[i])) {
            broken[i] = 1;
            any = true;
            primitive.positions[i] = glm::vec3(0.0F);
        }
    }
    if (!any) {
        return;
    }
    const std::size_t corners = primitive.topology == Topology::kTriangles ? 3
                                : primitive.topology == Topology::kLines   ? 2
                                                                           : 1;
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i + corners <= primitive.indices.size(); i += corners) {
        const auto first = primitive.indices.begin() + std::ptrdiff_t(i);
        const auto last = first + std::ptrdiff_t(corners);
        if (std::none_of(first, last, [&](std::uint32_t index) { return broken[index] != 0; })) {
            kept.insert(kept.end(), first, last);
        }
    }
    report.repaired(place.at("attributes").at("POSITION"),
                    "holds positions that are not finite numbers; what they belong to (" +
                        std::to_string((primitive.indices.size() - kept.size()) / corners) +
                        " of " + std::to_string(primitive.indices.size() / corners) +
                        " pieces) is left out");
    primitive.indices = std::move(kept);
}

template <typename T>
void keepVertices(std::vector<T>& values, const std::vector<std::uint32_t>& kept) {
    if (values.empty()) {
        return;
    }
    std::vector<T> result;
    result.reserve(kept.size());
    for (const std::uint32_t vertex : kept) {
        result.push_back(values[vertex]);
    }
    values = std::move(result);
}

// Vertices that nothing draws: primitives often share one long vertex buffer.
void dropUnusedVertices(Primitive& primitive) {
    constexpr std::uint32_t kUnused = 0xFFFFFFFF;
    std::vector<std::uint32_t> newIndex(primitive.positions.size(), kUnused);
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t index : primitive.indices) {
        newIndex[index] = 0;
    }
    for (std::uint32_t i = 0; i < newIndex.size(); ++i) {
        if (newIndex[i] != kUnused) {
            newIndex[i] = std::uint32_t(kept.size());
            kept.push_back(i);
        }
    }
    if (kept.size() == primitive.positions.size()) {
        return;
    }
    for (std::uint32_t& index : primitive.indices) {
        index = newIndex[index];
    }
    keepVertices(primitive.positions, kept);
    keepVertices(primitive.normals, kept);
    keepVertices(primitive.tangents, kept);
    keepVertices(primitive.uv0, kept);
    keepVertices(primitive.uv1, kept);
    keepVertices(primitive.colors, kept);
}

// Normals and tangents of unit length; those that have no direction get a stand-in.
void normalise(Primitive& primitive, const Place& place, Report& report) {
    std::size_t broken = 0;
    for (glm::vec3& normal : primitive.normals) {
        const float length = glm::length(normal);
        const bool usable = std::isfinite(length) && length > 1e-20F;
        normal = usable ? normal / length : glm::vec3(0.0F, 1.0F, 0.0F);
        broken += usable ? 0 : 1;
    }
    if (broken > 0) {
        report.repaired(place.at("attributes").at("NORMAL"),
                        std::to_string(broken) + " normals have no direction; +Y is used");
    }
    broken = 0;
    for (std::size_t i = 0; i < primitive.tangents.size(); ++i) {
        glm::vec4& tangent = primitive.tangents[i];
        const glm::vec3 axis(tangent.x, tangent.y, tangent.z);
        const float length = glm::length(axis);
        const bool usable = std::isfinite(length) && length > 1e-20F;
        tangent = glm::vec4(usable ? axis / length : glm::vec3(1.0F, 0.0F, 0.0F),
                            tangent.w < 0.0F ? -1.0F : 1.0F);
        broken += usable ? 0 : 1;
    }
    if (broken > 0) {
        report.repaired(place.at("attributes").at("TANGENT"),
                        std::to_string(broken) + " tangents have no direction; +X is used");
    }
}

void completeTriangles(Primitive& primitive, int normalMapUv) {
    if (primitive.normals.empty()) {
        makeFlatNormals(primitive);
    }
    const std::vector<glm::vec2>& uv = normalMapUv == 1 ? primitive.uv1 : primitive.uv0;
    if (normalMapUv < 0) {
        primitive.tangents.clear();
    } else if (primitive.tangents.empty() && !uv.empty()) {
        makeTangents(primitive, uv);
    }
}

RawPrimitive readRaw(const Import& import, const tinygltf::Primitive& source, const Job& job,
                     const Place& place) {
    const json& draco =
        extension(element(import.json, "meshes", job.mesh)["primitives"][job.primitive],
                  "KHR_draco_mesh_compression");
    if (!draco.is_null()) {
        return readDracoPrimitive(import, source, draco,
                                  place.at("extensions").at("KHR_draco_mesh_compression"));
    }
    RawPrimitive raw;
    readPlainAttributes(import, source, raw.primitive);
    raw.hasIndices = source.indices >= 0;
    if (raw.hasIndices) {
        raw.primitive.indices = readIndices(import, std::size_t(source.indices));
    }
    return raw;
}

void checkIndices(const Primitive& primitive, const Place& place) {
    const auto wrong =
        std::find_if(primitive.indices.begin(), primitive.indices.end(),
                     [&](std::uint32_t index) { return index >= primitive.positions.size(); });
    if (wrong != primitive.indices.end()) {
        badInput(place.at("indices"),
                 "element " + std::to_string(wrong - primitive.indices.begin()) + " is " +
                     std::to_string(*wrong) + ", but there are only " +
                     std::to_string(primitive.positions.size()) + " vertices");
    }
}

std::optional<Primitive> readPrimitive(const Import& import, Job& job,
                                       const NormalMapUvs& normalMapUvs,
                                       std::atomic<std::uint64_t>& taken) {
    const Place place = import.file.at("meshes").at(job.mesh).at("primitives").at(job.primitive);
    const tinygltf::Primitive& source = import.model.meshes[job.mesh].primitives[job.primitive];
    if (!accessorOf(source, "POSITION")) {
        badInput(place.at("attributes"), "has no POSITION; there is nothing to draw");
    }
    RawPrimitive raw = readRaw(import, source, job, place);
    Primitive& primitive = raw.primitive;
    if (primitive.positions.empty()) {
        badInput(place, "has no positions in its Draco data");
    }
    if (!raw.hasIndices) {
        primitive.indices.resize(primitive.positions.size());
        std::iota(primitive.indices.begin(), primitive.indices.end(), 0U);
    }
    checkIndices(primitive, place);
    if ((taken += primitive.positions.size() + primitive.indices.size()) > kMaxVerticesAndIndices) {
        badInput(place, "the file's vertices and indices together are over the limit of " +
                            std::to_string(kMaxVerticesAndIndices));
    }
    const int mode = raw.isTriangleList ? TINYGLTF_MODE_TRIANGLES : source.mode;
    primitive.topology = topologyOf(mode);
    primitive.indices = unrollIndices(mode, std::move(primitive.indices));
    primitive.material = source.material;

    mendAttributes(primitive, place, job.report);
    dropNonFinite(primitive, place, job.report);
    if (primitive.indices.empty()) {
        badInput(place, "has too few vertices to draw anything");
    }
    dropUnusedVertices(primitive);
    normalise(primitive, place, job.report);
    if (primitive.topology == Topology::kTriangles) {
        const std::size_t material =
            source.material >= 0 ? std::size_t(source.material) : normalMapUvs.size() - 1;
        completeTriangles(primitive, normalMapUvs[material]);
    } else {
        primitive.tangents.clear();
    }
    for (const glm::vec3& position : primitive.positions) {
        primitive.bounds.add(glm::dvec3(position));
    }
    return std::move(primitive);
}

void append(const Report& part, Report& whole) {
    for (const Report::Entry& entry : part.entries()) {
        switch (entry.kind) {
            case Report::Kind::kIgnored:
                whole.ignored(entry.place, entry.message);
                break;
            case Report::Kind::kRepaired:
                whole.repaired(entry.place, entry.message);
                break;
            case Report::Kind::kHint:
                whole.hint(entry.place, entry.message);
                break;
        }
    }
}

}  // namespace

std::vector<Mesh> readMeshes(const Import& import, const std::vector<std::size_t>& wanted,
                             const NormalMapUvs& normalMapUvs, Report& report) {
    std::vector<Job> jobs;
    for (const std::size_t mesh : wanted) {
        for (std::size_t p = 0; p < import.model.meshes[mesh].primitives.size(); ++p) {
            jobs.push_back({mesh, p, std::nullopt, {}});
        }
    }
    std::atomic<std::uint64_t> taken = 0;
    Progress progress("decoding meshes", jobs.size());
    parallelFor(jobs.size(), [&](std::size_t i) {
        Job& job = jobs[i];
        try {
            job.result = readPrimitive(import, job, normalMapUvs, taken);
        } catch (const Error& error) {
            job.report.ignored(error.place(), reasonOf(error) + "; primitive " +
                                                  std::to_string(job.primitive) + " of mesh " +
                                                  std::to_string(job.mesh) + " is not drawn");
        }
        progress.step();
    });
    std::vector<Mesh> meshes(wanted.size());
    std::size_t next = 0;
    for (std::size_t m = 0; m < wanted.size(); ++m) {
        const tinygltf::Mesh& source = import.model.meshes[wanted[m]];
        meshes[m].name = source.name;
        for (std::size_t p = 0; p < source.primitives.size(); ++p, ++next) {
            append(jobs[next].report, report);
            if (jobs[next].result) {
                meshes[m].primitives.push_back(std::move(*jobs[next].result));
            }
        }
    }
    return meshes;
}

}  // namespace ribalta::gltf
