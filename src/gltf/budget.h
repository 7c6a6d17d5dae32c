// Budget: what a file has asked for so far, held against LoadLimits. Takes no memory itself.
#pragma once

#include <atomic>
#include <cstdint>

#include "base/error.h"
#include "gltf/load_options.h"

namespace ribalta::gltf {

/// A file asks for more than it may. No part of it that could be left out: the file is refused.
class LimitError : public Error {
  public:
    using Error::Error;
};

/// May be used from several threads at once. Every function throws LimitError at `place`, that
/// names the limit and how to raise it, where the file would be over it.
class Budget {
  public:
    explicit Budget(const LoadLimits& limits) : limits_(limits) {}

    const LoadLimits& limits() const { return limits_; }

    /// To be called before memory is taken: for good, or for a while.
    void takeMemory(std::uint64_t bytes, const Place& place);
    void expectMemory(std::uint64_t bytes, const Place& place) const;
    /// Bytes that are left.
    std::uint64_t memoryLeft() const;

    /// The same for vertices and indices.
    void takeVertices(std::uint64_t count, const Place& place);
    void expectVertices(std::uint64_t count, const Place& place) const;

    /// Nodes of the file, and what a node stands for several times.
    void takeNodes(std::uint64_t count, const Place& place);

    /// Elements read from accessors. A small file can have one read over and over, for primitives
    /// by the thousand: that costs time, and ends at kReadsPerVertex times the limit of vertices.
    void takeReads(std::uint64_t count, const Place& place);

  private:
    const LoadLimits limits_;
    std::atomic<std::uint64_t> memory_ = 0;
    std::atomic<std::uint64_t> vertices_ = 0;
    std::atomic<std::uint64_t> nodes_ = 0;
    std::atomic<std::uint64_t> reads_ = 0;
};

inline constexpr std::uint64_t kReadsPerVertex = 30;

}  // namespace ribalta::gltf
