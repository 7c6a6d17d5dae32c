#include "render/passes/deform.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include <shared/deform.h>
#include <shared/slots.h>

#include "base/error.h"
#include "gl/counters.h"

namespace ribalta {
namespace {

// Parts of buffers that shaders are shown start at multiples of this: the most OpenGL may ask for.
constexpr std::size_t kAlignment = 256;
// Work groups in a row of a dispatch; OpenGL offers 65535 at least.
constexpr std::size_t kGroupsInRow = 32768;

static_assert(kDeformedAlignment * 3 * sizeof(float) % kAlignment == 0);
static_assert(kDeformedAlignment * gpu::kAttributeFloats * sizeof(float) % kAlignment == 0);
static_assert(sizeof(Influence) == 8);

std::vector<float> restOf(const Primitive& primitive) {
    std::vector<float> rest(primitive.positions.size() * gpu::kRestFloats, 0.0F);
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        float* vertex = &rest[i * gpu::kRestFloats];
        std::memcpy(vertex, &primitive.positions[i], 3 * sizeof(float));
        if (!primitive.normals.empty()) {
            std::memcpy(vertex + 3, &primitive.normals[i], 3 * sizeof(float));
        }
        if (!primitive.tangents.empty()) {
            std::memcpy(vertex + 6, &primitive.tangents[i], 4 * sizeof(float));
        }
    }
    return rest;
}

// Appends, and says where it starts; -1 where there is nothing.
int append(const std::vector<glm::vec3>& values, std::vector<glm::vec3>& all) {
    if (values.empty()) {
        return -1;
    }
    const auto start = int(3 * all.size());
    all.insert(all.end(), values.begin(), values.end());
    return start;
}

// Appends bytes at the next place that shaders may be shown, and says where.
template <typename Value>
std::size_t appendAligned(const std::vector<Value>& values, std::vector<std::byte>& all) {
    const std::size_t start = (all.size() + kAlignment - 1) / kAlignment * kAlignment;
    const std::size_t bytes = values.size() * sizeof(Value);
    all.resize(start + std::max(bytes, sizeof(glm::mat4)));
    if (bytes > 0) {
        std::memcpy(&all[start], values.data(), bytes);
    }
    return start;
}

std::vector<gpu::ActiveTarget> activeTargets(const Deformer& deformer,
                                             const std::vector<glm::ivec3>& starts) {
    std::vector<gpu::ActiveTarget> active;
    for (std::size_t t = 0; t < std::min(starts.size(), deformer.weights.size()); ++t) {
        if (deformer.weights[t] != 0.0F) {
            active.push_back({glm::ivec4(starts[t].x, starts[t].y, starts[t].z,
                                         std::bit_cast<std::int32_t>(deformer.weights[t]))});
        }
    }
    return active;
}

gpu::DeformJob describe(const Primitive& primitive, const Deformer& deformer, std::size_t active) {
    const bool isSkinned = !deformer.localFromMesh.empty();
    const int flags = (primitive.normals.empty() ? 0 : gpu::kDeformNormals) |
                      (primitive.tangents.empty() ? 0 : gpu::kDeformTangents) |
                      (primitive.flatNormals ? gpu::kDeformFlat : 0);
    return {glm::ivec4(primitive.positions.size(), isSkinned ? primitive.influencesPerVertex : 0,
                       active, flags),
            glm::ivec4(deformer.localFromMesh.size(), 0, 0, 0)};
}

void bindPart(int slot, const Buffer& buffer, std::size_t start, std::size_t bytes) {
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, GLuint(slot), buffer.name(), GLintptr(start),
                      GLsizeiptr(bytes));
}

void bindAll(int slot, const Buffer& buffer) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, GLuint(slot), buffer.name());
}

}  // namespace

DeformPass::DeformPass() : program_({"passes/deform.comp"}) {
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    mostBytes_ = std::size_t(most);
}

const DeformPass::Source& DeformPass::sourceOf(const Scene& scene, int mesh,
                                               std::size_t primitive) {
    const auto [known, isNew] = sources_.try_emplace({mesh, primitive});
    Source& source = known->second;
    if (!isNew) {
        return source;
    }
    const Mesh& owner = scene.meshes[std::size_t(mesh)];
    const Primitive& shape = owner.primitives[primitive];
    std::vector<glm::vec3> displacements;
    for (const MorphTarget& target : shape.targets) {
        const int positions = append(target.positions, displacements);
        const int normals = shape.flatNormals ? -1 : append(target.normals, displacements);
        source.starts.emplace_back(positions, normals, append(target.tangents, displacements));
    }
    const std::size_t largest = std::max(
        {displacements.size() * sizeof(glm::vec3), shape.influences.size() * sizeof(Influence),
         shape.positions.size() * sizeof(float) * gpu::kAttributeFloats});
    if (largest > mostBytes_) {
        throw Error(ErrorKind::kJobFailed, {},
                    "mesh '" + oneLine(owner.name) + "' cannot be deformed here: it needs " +
                        std::to_string(largest) +
                        " bytes in one buffer, and this OpenGL shows a "
                        "shader at most " +
                        std::to_string(mostBytes_) +
                        "; draw it with another graphics driver, or split the mesh");
    }
    source.rest.write("mesh at rest", bytesOf(restOf(shape)));
    source.influences.write("influences", bytesOf(shape.influences));
    source.displacements.write("morph targets", bytesOf(displacements));
    return source;
}

std::vector<DeformPass::Job> DeformPass::upload(const std::vector<int>& deformers,
                                                const Scene& scene, const GpuScene& gpuScene) {
    std::vector<Job> jobs;
    std::vector<gpu::DeformJob> descriptions;
    std::vector<std::byte> joints;
    std::vector<std::byte> active;
    for (const int index : deformers) {
        const Deformer& deformer = scene.deformers[std::size_t(index)];
        const int mesh = scene.nodes[std::size_t(deformer.node)].mesh;
        const auto& parts = gpuScene.geometry().deformedParts(deformer.node);
        const std::size_t firstJoint = appendAligned(deformer.localFromMesh, joints);
        const std::size_t jointBytes = joints.size() - firstJoint;
        for (std::size_t p = 0; p < parts.size(); ++p) {
            const Source& source = sourceOf(scene, mesh, p);
            const std::vector<gpu::ActiveTarget> targets = activeTargets(deformer, source.starts);
            const std::size_t firstTarget = appendAligned(targets, active);
            const Primitive& primitive = scene.meshes[std::size_t(mesh)].primitives[p];
            jobs.push_back({&primitive, &source, std::size_t(parts[p].baseVertex), firstJoint,
                            jointBytes, firstTarget, active.size() - firstTarget});
            descriptions.push_back(describe(primitive, deformer, targets.size()));
        }
    }
    jobs_.write("deform jobs", spreadForUniforms(descriptions));
    joints_.write("joints", joints);
    active_.write("active morph targets", active);
    return jobs;
}

void DeformPass::bind(const Job& job, const GpuScene& gpuScene) const {
    const std::size_t vertices = job.primitive->positions.size();
    constexpr std::size_t kPositionBytes = 3 * sizeof(float);
    constexpr std::size_t kAttributeBytes = gpu::kAttributeFloats * sizeof(float);
    bindAll(gpu::kDeformRestSlot, job.source->rest);
    bindAll(gpu::kDeformInfluencesSlot, job.source->influences);
    bindAll(gpu::kDeformTargetsSlot, job.source->displacements);
    bindPart(gpu::kDeformJointsSlot, joints_, job.joints, job.jointBytes);
    bindPart(gpu::kDeformActiveSlot, active_, job.active, job.activeBytes);
    bindPart(gpu::kDeformPositionsSlot, gpuScene.geometry().positions(),
             job.firstVertex * kPositionBytes, vertices * kPositionBytes);
    bindPart(gpu::kDeformAttributesSlot, gpuScene.geometry().attributes(),
             job.firstVertex * kAttributeBytes, vertices * kAttributeBytes);
}

void DeformPass::draw(const std::vector<int>& deformers, const Scene& scene,
                      const GpuScene& gpuScene) {
    const std::vector<Job> jobs = upload(deformers, scene, gpuScene);
    glUseProgram(program_.name());
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        jobs_.bindUniform(gpu::kDeformJobSlot, int(i));
        bind(jobs[i], gpuScene);
        const std::size_t groups =
            (jobs[i].primitive->positions.size() + gpu::kDeformGroup - 1) / gpu::kDeformGroup;
        const std::size_t rows = (groups + kGroupsInRow - 1) / kGroupsInRow;
        glDispatchCompute(GLuint(std::min(groups, kGroupsInRow)), GLuint(rows), 1);
        ++glCounters().drawCalls;
    }
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

}  // namespace ribalta
