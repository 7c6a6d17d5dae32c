// What the beam passes share: how a beam program is named and what its settings are.
#pragma once

#include <string>
#include <vector>

#include <shared/beams.h>

#include "render/frame_plan.h"

namespace ribalta {

/// The defines of a beam program for this work.
std::vector<std::string> beamDefines(const BeamsWork& work);

gpu::BeamSettings describeBeams(const BeamsWork& work);

}  // namespace ribalta
