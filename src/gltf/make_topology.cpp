#include "gltf/make_topology.h"

namespace ribalta::gltf {
namespace {

enum Mode : int { kPoints, kLines, kLineLoop, kLineStrip, kTriangles, kTriangleStrip, kFan };

}  // namespace

Topology topologyOf(int mode) {
    return mode == kPoints     ? Topology::kPoints
           : mode < kTriangles ? Topology::kLines
                               : Topology::kTriangles;
}

std::size_t unrolledCount(int mode, std::size_t count) {
    switch (mode) {
        case kLines:
            return count / 2 * 2;
        case kTriangles:
            return count / 3 * 3;
        case kLineLoop:
            return count > 1 ? 2 * count : 0;
        case kLineStrip:
            return count > 1 ? 2 * (count - 1) : 0;
        case kTriangleStrip:
        case kFan:
            return count > 2 ? 3 * (count - 2) : 0;
        default:
            return count;
    }
}

std::vector<std::uint32_t> unrollIndices(int mode, std::vector<std::uint32_t> indices) {
    const std::size_t count = indices.size();
    if (mode == kPoints || mode == kLines || mode == kTriangles) {
        indices.resize(unrolledCount(mode, count));
        return indices;
    }
    std::vector<std::uint32_t> result;
    result.reserve(unrolledCount(mode, count));
    switch (mode) {
        case kLineLoop:
        case kLineStrip:
            for (std::size_t i = 1; i < count; ++i) {
                result.insert(result.end(), {indices[i - 1], indices[i]});
            }
            if (mode == kLineLoop && count > 1) {
                result.insert(result.end(), {indices[count - 1], indices[0]});
            }
            return result;
        case kTriangleStrip:
            for (std::size_t i = 2; i < count; ++i) {
                // Every other triangle of a strip is wound the other way.
                const std::size_t odd = i % 2;
                result.insert(result.end(),
                              {indices[i - 2], indices[i - 1 + odd], indices[i - odd]});
            }
            return result;
        case kFan:
            for (std::size_t i = 2; i < count; ++i) {
                result.insert(result.end(), {indices[i - 1], indices[i], indices[0]});
            }
            return result;
        default:
            return result;
    }
}

}  // namespace ribalta::gltf
