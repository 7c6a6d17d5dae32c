#include "gltf/read_mesh.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "base/parallel_for.h"
#include "base/progress.h"
#include "gltf/bad_input.h"
#include "gltf/make_normals.h"
#include "gltf/make_tangents.h"
#include "gltf/make_topology.h"
#include "gltf/mend_primitive.h"
#include "gltf/read_attributes.h"
#include "gltf/read_deformers.h"
#include "gltf/read_influences.h"
#include "gltf/read_targets.h"
#include "gltf/share_geometry.h"
#include "gltf/tally.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// What one thread turns one glTF primitive into.
struct Job {
    MeshUse use;
    std::size_t primitive = 0;  // of that mesh
    std::optional<Primitive> result;
    std::optional<Error> fault;  // why there is no result, where the file is to blame
    Report report;
    const Job* twin = nullptr;  // which reads the same data in the same way
};

// How many displacements of morph targets may still be read, of all primitives together.
class Displacements {
  public:
    bool take(std::uint64_t count) { return taken_.fetch_add(count) + count <= kMaxDisplacements; }

  private:
    std::atomic<std::uint64_t> taken_ = 0;
};

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

// glTF allows buffers without data, such as the fallback buffers of EXT_meshopt_compression.
std::optional<int> viewWithoutData(const Import& import, const tinygltf::Primitive& source) {
    const auto lacksData = [&](int accessor) {
        const int view = import.model.accessors[std::size_t(accessor)].bufferView;
        const auto& views = import.model.bufferViews;
        return view >= 0 && !isPacked(import, std::size_t(view)) &&
               import.buffers[std::size_t(views[std::size_t(view)].buffer)].bytes.empty();
    };
    if (source.indices >= 0 && lacksData(source.indices)) {
        return import.model.accessors[std::size_t(source.indices)].bufferView;
    }
    for (const auto& [name, accessor] : source.attributes) {
        if (lacksData(accessor)) {
            return import.model.accessors[std::size_t(accessor)].bufferView;
        }
    }
    return std::nullopt;
}

void completeTriangles(Primitive& primitive, int tangentUv) {
    if (primitive.normals.empty()) {
        makeFlatNormals(primitive);
    }
    const std::vector<glm::vec2>& uv = tangentUv == 1 ? primitive.uv1 : primitive.uv0;
    if (tangentUv < 0) {
        primitive.tangents.clear();
    } else if (primitive.tangents.empty() && !uv.empty()) {
        makeTangents(primitive, uv);
    }
}

// What a primitive of so many vertices and indices takes.
std::uint64_t bytesOf(const Primitive& primitive, std::uint64_t vertices, std::uint64_t indices) {
    const auto each = [](const auto& values) { return values.empty() ? 0 : sizeof(values[0]); };
    return vertices *
               (each(primitive.positions) + each(primitive.normals) + each(primitive.tangents) +
                each(primitive.uv0) + each(primitive.uv1) + each(primitive.colors)) +
           indices * sizeof(std::uint32_t);
}

// What is made of it on the way: strips become single triangles, those may get vertices of their
// own for flat normals, and vertices tangents.
void expectGrowth(const Import& import, int mode, bool wantsTangents, const Primitive& primitive,
                  const Place& place) {
    const std::uint64_t indices = unrolledCount(mode, primitive.indices.size());
    const bool isFlat = topologyOf(mode) == Topology::kTriangles && primitive.normals.empty();
    const std::uint64_t vertices = isFlat ? indices : primitive.positions.size();
    // Two directions a vertex in double precision, and the tangent itself.
    const std::uint64_t forTangents =
        wantsTangents ? 2 * sizeof(glm::dvec3) + sizeof(glm::vec4) : 0;
    const std::uint64_t forNormals = isFlat ? sizeof(glm::vec3) : 0;
    import.budget->expectVertices(vertices + indices, place);
    import.budget->expectMemory(
        bytesOf(primitive, vertices, indices) + vertices * (forTangents + forNormals), place);
}

// What the vertices hang on and where they may go, as the file has it.
void readDeformation(const Import& import, const MeshUse& use, const std::vector<JointSet>& joints,
                     const json& object, const Place& place, Displacements& left,
                     Primitive& primitive, Report& report) {
    if (use.joints > 0) {
        const std::uint64_t most = 4 * std::max<std::uint64_t>(joints.size(), 1);
        import.budget->expectMemory(2 * most * primitive.positions.size() * sizeof(Influence),
                                    place);
        setInfluences(joints, use.joints, place, primitive, report);
    }
    if (use.isMorphed) {
        primitive.targets = readTargets(
            import, object, primitive.positions.size(), place,
            [&](std::uint64_t count) { return left.take(count); }, report);
    }
    std::uint64_t displacements = 0;
    for (const MorphTarget& target : primitive.targets) {
        displacements += target.positions.size() + target.normals.size() + target.tangents.size();
    }
    import.budget->takeMemory(
        primitive.influences.size() * sizeof(Influence) + displacements * sizeof(glm::vec3), place);
}

// Displacements of what is there no longer, or was made here, mean nothing.
void completeDeformation(bool hadTangents, Primitive& primitive) {
    for (MorphTarget& target : primitive.targets) {
        if (primitive.normals.empty()) {
            target.normals.clear();
        }
        if (primitive.tangents.empty() || !hadTangents) {
            target.tangents.clear();
        }
        for (const glm::vec3& displacement : target.positions) {
            target.bounds.add(glm::dvec3(displacement));
        }
    }
    const auto each = std::size_t(primitive.influencesPerVertex);
    for (std::size_t i = 0; i < primitive.influences.size(); ++i) {
        const Influence& influence = primitive.influences[i];
        if (influence.weight == 0.0F) {
            continue;
        }
        if (influence.joint >= primitive.jointBounds.size()) {
            primitive.jointBounds.resize(influence.joint + 1);
        }
        primitive.jointBounds[influence.joint].add(glm::dvec3(primitive.positions[i / each]));
    }
}

// Nothing where the primitive draws nothing, which is reported. Throws Error(kBadInput).
std::optional<Primitive> readPrimitive(const Import& import, const TangentUvs& tangentUvs,
                                       const MeshUse& use, std::size_t index, Displacements& left,
                                       Report& report) {
    const Place place = import.file.at("meshes").at(use.mesh).at("primitives").at(index);
    const tinygltf::Primitive& source = import.model.meshes[use.mesh].primitives[index];
    if (!source.attributes.contains("POSITION")) {
        report.ignored(place.at("attributes"), "has no POSITION; there is nothing to draw");
        return std::nullopt;
    }
    if (const auto view = viewWithoutData(import, source)) {
        report.ignored(place, "uses bufferView " + std::to_string(*view) +
                                  ", for which the file has no data; it is not drawn");
        return std::nullopt;
    }
    const json& object = element(import.json, "meshes", use.mesh)["primitives"][index];
    Primitive primitive;
    std::vector<JointSet> joints;
    const int mode = readAttributes(import, source, object, place, primitive,
                                    use.joints > 0 ? &joints : nullptr, report);
    if (primitive.positions.empty()) {
        badInput(place, "has no positions in its Draco data; export the mesh again");
    }
    checkIndices(primitive, place);
    const std::size_t material =
        source.material >= 0 ? std::size_t(source.material) : tangentUvs.size() - 1;
    const int tangentUv = tangentUvs[material];
    expectGrowth(import, mode, tangentUv >= 0, primitive, place);
    readDeformation(import, use, joints, object, place, left, primitive, report);
    primitive.topology = topologyOf(mode);
    primitive.indices = unrollIndices(mode, std::move(primitive.indices));
    primitive.material = source.material;
    mendPrimitive(primitive, place, report);
    if (primitive.indices.empty()) {
        report.ignored(place, "has too few vertices to draw anything");
        return std::nullopt;
    }
    const bool hadTangents = !primitive.tangents.empty();
    if (primitive.topology == Topology::kTriangles) {
        completeTriangles(primitive, tangentUv);
    } else {
        primitive.tangents.clear();
    }
    completeDeformation(hadTangents, primitive);
    for (const glm::vec3& position : primitive.positions) {
        primitive.bounds.add(glm::dvec3(position));
    }
    const std::size_t vertices = primitive.positions.size();
    import.budget->takeVertices(vertices + primitive.indices.size(), place);
    import.budget->takeMemory(bytesOf(primitive, vertices, primitive.indices.size()), place);
    return primitive;
}

// The accessors that the jobs read: twins are copies.
std::vector<std::size_t> listAccessors(const Import& import, const std::vector<Job>& jobs) {
    std::vector<std::size_t> accessors;
    for (const Job& job : jobs) {
        if (job.twin != nullptr) {
            continue;
        }
        const tinygltf::Primitive& source =
            import.model.meshes[job.use.mesh].primitives[job.primitive];
        if (source.indices >= 0) {
            accessors.push_back(std::size_t(source.indices));
        }
        for (const auto& [name, accessor] : source.attributes) {
            accessors.push_back(std::size_t(accessor));
        }
    }
    return accessors;
}

std::vector<Job> listJobs(const Import& import, const std::vector<MeshUse>& wanted) {
    std::vector<Job> jobs;
    for (const MeshUse& use : wanted) {
        for (std::size_t p = 0; p < import.model.meshes[use.mesh].primitives.size(); ++p) {
            Job& job = jobs.emplace_back();
            job.use = use;
            job.primitive = p;
        }
    }
    return jobs;
}

// All that a primitive is read from, but for its material. None where it changes shape: what hangs
// on joints or has targets is read for its node.
using Source = std::tuple<std::map<std::string, int>, int, int, int, std::string>;

std::optional<Source> sourceOf(const Import& import, const TangentUvs& tangentUvs, const Job& job) {
    if (job.use.isMorphed || job.use.joints > 0) {
        return std::nullopt;
    }
    const tinygltf::Primitive& source = import.model.meshes[job.use.mesh].primitives[job.primitive];
    const json& object = element(import.json, "meshes", job.use.mesh)["primitives"][job.primitive];
    const json& draco = extension(object, "KHR_draco_mesh_compression");
    const std::size_t material =
        source.material >= 0 ? std::size_t(source.material) : tangentUvs.size() - 1;
    return Source(source.attributes, source.indices, source.mode, tangentUvs[material],
                  draco.is_null() ? "" : draco.dump());
}

void findTwins(const Import& import, const TangentUvs& tangentUvs, std::vector<Job>& jobs) {
    std::map<Source, const Job*> first;
    for (Job& job : jobs) {
        if (std::optional<Source> source = sourceOf(import, tangentUvs, job)) {
            const auto [known, isNew] = first.emplace(std::move(*source), &job);
            job.twin = isNew ? nullptr : known->second;
        }
    }
}

// Only where there is nothing to report, which would be of another place.
bool copyTwin(const Import& import, Job& job) {
    if (!job.twin->result || !job.twin->report.entries().empty()) {
        return false;
    }
    const Primitive& twin = *job.twin->result;
    const Place place =
        import.file.at("meshes").at(job.use.mesh).at("primitives").at(job.primitive);
    const std::size_t vertices = twin.positions.size();
    import.budget->takeVertices(vertices + twin.indices.size(), place);
    import.budget->takeMemory(bytesOf(twin, vertices, twin.indices.size()), place);
    job.result = twin;
    job.result->material = import.model.meshes[job.use.mesh].primitives[job.primitive].material;
    return true;
}

void runJobs(const Import& import, const TangentUvs& tangentUvs, std::vector<Job>& jobs) {
    findTwins(import, tangentUvs, jobs);
    const ExpectedReads expected(import, listAccessors(import, jobs));
    Displacements left;
    Progress progress("decoding meshes", jobs.size());
    const auto run = [&](Job& job) {
        try {
            job.result =
                readPrimitive(import, tangentUvs, job.use, job.primitive, left, job.report);
        } catch (const LimitError&) {
            throw;
        } catch (const Error& error) {
            job.fault = error;
        }
        progress.step();
    };
    parallelFor(jobs.size(), [&](std::size_t i) {
        if (jobs[i].twin == nullptr) {
            run(jobs[i]);
        }
    });
    parallelFor(jobs.size(), [&](std::size_t i) {
        if (jobs[i].twin != nullptr && !copyTwin(import, jobs[i])) {
            run(jobs[i]);
        }
    });
}

// Where every primitive is broken there is no scene to draw: the first one's fault is the file's.
void checkSomethingIsLeft(const std::vector<Job>& jobs) {
    const auto firstFault =
        std::find_if(jobs.begin(), jobs.end(), [](const Job& job) { return job.fault; });
    const bool isAnyLeft =
        std::any_of(jobs.begin(), jobs.end(), [](const Job& job) { return job.result; });
    if (firstFault != jobs.end() && !isAnyLeft) {
        throw *firstFault->fault;
    }
}

}  // namespace

std::vector<Mesh> readMeshes(const Import& import, const std::vector<MeshUse>& wanted,
                             const TangentUvs& tangentUvs, Report& report) {
    std::vector<Job> jobs = listJobs(import, wanted);
    runJobs(import, tangentUvs, jobs);
    checkSomethingIsLeft(jobs);
    std::vector<Mesh> meshes(wanted.size());
    std::size_t next = 0;
    for (std::size_t m = 0; m < wanted.size(); ++m) {
        const tinygltf::Mesh& source = import.model.meshes[wanted[m].mesh];
        meshes[m].name = source.name;
        for (std::size_t p = 0; p < source.primitives.size(); ++p, ++next) {
            Job& job = jobs[next];
            append(job.report, report);
            if (job.fault) {
                report.ignored(job.fault->place(),
                               reasonOf(*job.fault) + "; primitive " + std::to_string(p) +
                                   " of mesh " + std::to_string(wanted[m].mesh) + " is not drawn");
            } else if (job.result) {
                meshes[m].primitives.push_back(std::move(*job.result));
            }
        }
    }
    shareGeometry(meshes);
    return meshes;
}

}  // namespace ribalta::gltf
