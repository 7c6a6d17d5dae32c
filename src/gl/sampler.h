// Samplers: how textures are read, apart from what they hold.
#pragma once

#include "gl/handle.h"

namespace ribalta {

inline void deleteSampler(GLuint name) {
    glDeleteSamplers(1, &name);
}

/// Reads a shadow map's nearest depth as it is, without comparing, and beyond the edge the edge's.
Handle<deleteSampler> makeDepthSampler();

}  // namespace ribalta
