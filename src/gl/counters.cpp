#include "gl/counters.h"

#include <algorithm>

namespace ribalta {

GlCounters& glCounters() {
    static GlCounters counters;
    return counters;
}

void countAllocation(std::uint64_t bytes) {
    GlCounters& counters = glCounters();
    counters.bytesAllocated += bytes;
    counters.peakBytes = std::max(counters.peakBytes, counters.bytesAllocated);
}

void countRelease(std::uint64_t bytes) {
    glCounters().bytesAllocated -= bytes;
}

}  // namespace ribalta
