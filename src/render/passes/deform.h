// Deform: brings skinned and morphed meshes into their shape, in the buffers that all passes draw
// from. Run before them, for what has another shape than before.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"
#include "render/gpu_scene.h"
#include "scene/scene.h"

namespace ribalta {

class DeformPass {
  public:
    DeformPass();
    /// Deforms these of the scene's deformers. Meshes are uploaded when they are first deformed,
    /// and do not change. Throws Error(kJobFailed) where one is larger than OpenGL can show a
    /// shader.
    void draw(const std::vector<int>& deformers, const Scene& scene, const GpuScene& gpuScene);

  private:
    // What a primitive is deformed from.
    struct Source {
        Buffer rest;
        Buffer influences;
        Buffer displacements;
        std::vector<glm::ivec3> starts;  ///< by target: see ActiveTarget
    };
    struct Job {
        const Primitive* primitive = nullptr;
        const Source* source = nullptr;
        std::size_t firstVertex = 0;
        std::size_t joints = 0;  ///< where its deformer's matrices start, bytes
        std::size_t jointBytes = 0;
        std::size_t active = 0;  ///< where its targets that count start, bytes
        std::size_t activeBytes = 0;
    };

    const Source& sourceOf(const Scene& scene, int mesh, std::size_t primitive);
    std::vector<Job> upload(const std::vector<int>& deformers, const Scene& scene,
                            const GpuScene& gpuScene);
    void bind(const Job& job, const GpuScene& gpuScene) const;

    Program program_;
    std::size_t mostBytes_ = 0;  ///< that a shader can be shown of a buffer
    std::map<std::pair<int, std::size_t>, Source> sources_;  ///< by mesh and primitive
    Buffer jobs_;
    Buffer joints_;
    Buffer active_;
};

}  // namespace ribalta
