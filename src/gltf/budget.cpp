#include "gltf/budget.h"

#include <algorithm>
#include <string>

namespace ribalta::gltf {
namespace {

[[noreturn]] void refuse(std::uint64_t count, const char* what, std::uint64_t limit,
                         const char* key, const Place& place) {
    throw LimitError(ErrorKind::kBadInput, place,
                     "asks for " + std::to_string(count) + " " + what +
                         ", and the scene with that for more than the limit of " +
                         std::to_string(limit) + "; simplify it, or raise the limit (" + key +
                         ", as in --limits)");
}

// Saturates, so that no sum wraps around.
bool isOver(std::uint64_t taken, std::uint64_t count, std::uint64_t limit) {
    return taken > limit || count > limit - taken;
}

void take(std::atomic<std::uint64_t>& taken, std::uint64_t count, const char* what,
          std::uint64_t limit, const char* key, const Place& place) {
    std::uint64_t before = taken.load();
    do {
        if (isOver(before, count, limit)) {
            refuse(count, what, limit, key, place);
        }
    } while (!taken.compare_exchange_weak(before, before + count));
}

}  // namespace

void Budget::takeMemory(std::uint64_t bytes, const Place& place) {
    take(memory_, bytes, "bytes of memory", limits_.memory, "memory", place);
}

void Budget::expectMemory(std::uint64_t bytes, const Place& place) const {
    if (isOver(memory_, bytes, limits_.memory)) {
        refuse(bytes, "bytes of memory", limits_.memory, "memory", place);
    }
}

std::uint64_t Budget::memoryLeft() const {
    return limits_.memory - std::min<std::uint64_t>(memory_, limits_.memory);
}

void Budget::takeVertices(std::uint64_t count, const Place& place) {
    take(vertices_, count, "vertices and indices", limits_.vertices, "vertices", place);
}

void Budget::expectVertices(std::uint64_t count, const Place& place) const {
    if (isOver(vertices_, count, limits_.vertices)) {
        refuse(count, "vertices and indices", limits_.vertices, "vertices", place);
    }
}

void Budget::takeNodes(std::uint64_t count, const Place& place) {
    take(nodes_, count, "nodes", limits_.nodes, "nodes", place);
}

void Budget::takeReads(std::uint64_t count, const Place& place) {
    const std::uint64_t limit = limits_.vertices > UINT64_MAX / kReadsPerVertex
                                    ? UINT64_MAX
                                    : kReadsPerVertex * limits_.vertices;
    take(reads_, count, "elements of accessors to be read again and again", limit,
         "30 times vertices", place);
}

}  // namespace ribalta::gltf
