// BaselineSky: a sky of the literature as a frame has it: the tables of its model, where that has
// any, and what it lights a scene with. Shaders that include passes/sky_baseline.glsl ask it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gl/buffer.h"
#include "render/passes/sky_precomputed.h"
#include "render/sky_lighting.h"
#include "render/sky_settings.h"

namespace ribalta {

class BaselineSky {
  public:
    /// Makes the tables; see PrecomputedSky. The model must not be the renderer's own.
    BaselineSky(const Atmosphere& air, const DrawnSky& model);

    void bind() const;
    std::vector<std::string> defines() const;
    /// Computed on the GPU; waits for it. The sky lights what looks up as it does level ground,
    /// what looks down not at all, and what looks aside half as much: no model says more. Light
    /// scattered once alone lights nothing.
    SkyLighting lighting(const SkyDrawing& sky) const;

  private:
    Atmosphere air_;
    DrawnSky model_;
    Buffer atmosphere_;
    std::optional<PrecomputedSky> tables_;
};

}  // namespace ribalta
