// GlCounters: what OpenGL was really asked for. Tests hold the frame plan against it.
#pragma once

#include <cstdint>

namespace ribalta {

struct GlCounters {
    std::uint64_t drawCalls = 0;  ///< draws and dispatches
    std::uint64_t programsBuilt = 0;
    double programsMs = 0.0;  ///< wall time spent compiling and linking them
    std::uint64_t texturesMade = 0;
    std::uint64_t framebuffersMade = 0;
    std::uint64_t bytesAllocated = 0;  ///< live bytes of buffers and textures, without padding
    std::uint64_t peakBytes = 0;       ///< most there were of these
};

/// Counts since the program's start; one context a process is assumed.
GlCounters& glCounters();

/// Books `bytes` of a new or a deleted buffer or texture.
void countAllocation(std::uint64_t bytes);
void countRelease(std::uint64_t bytes);

}  // namespace ribalta
