// The drawn frame back in memory, rows from the top.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"

namespace ribalta {

/// Which further channels of a frame are read (design of the EXR layers).
struct FrameLayers {
    bool beams = false;          ///< beams.R, .G, .B in cd/m2
    bool transmittance = false;  ///< transmittance.R, .G, .B of the haze before the surface, 0..1
    bool depth = false;          ///< Z in metres along the view axis, infinity where nothing is hit
    bool normal = false;         ///< normal.X, .Y, .Z, unit, world; 0 where nothing is hit
};

/// R, G, B in cd/m2 and the layers asked for. Beams and normals must have been drawn
/// (FrameSettings::beamsOutput, normalOutput). Waits for the GPU.
FloatImage readFrame(const FramePlan& plan, const FrameTargets& targets, const FrameLayers& layers);

/// The picture for a screen: sRGB-encoded R, G, B.
std::vector<std::uint8_t> readDisplay(const FrameTargets& targets);

}  // namespace ribalta
