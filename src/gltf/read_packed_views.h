// Buffer views that EXT_meshopt_compression packs: decoded when they are first asked for, and kept
// for as long as they are needed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace ribalta::gltf {

struct Import;

/// The bytes of a buffer view, which are there for as long as this is.
struct ViewBytes : std::span<const std::byte> {
    std::shared_ptr<const std::vector<std::byte>> unpacked{};  ///< those of a packed view
};

/// One packed view. Filled by whichever thread asks first.
struct PackedView {
    std::mutex mutex;
    std::shared_ptr<const std::vector<std::byte>> bytes;
    std::exception_ptr fault;       ///< why there are no bytes
    std::size_t expectedReads = 0;  ///< the last of them takes the bytes along
};

/// By buffer view; null where it is plain. Empty where none is packed.
using PackedViews = std::vector<std::unique_ptr<PackedView>>;

/// Finds the packed views of a document; decodes nothing.
PackedViews findPackedViews(const nlohmann::json& root);

/// By buffer: whether it only stands in for packed views, for readers without the extension.
std::vector<char> findFallbackBuffers(const nlohmann::json& root);

bool isPacked(const Import& import, std::size_t view);

/// The decoded bytes of a packed view. Safe from several threads. Throws Error(kBadInput).
ViewBytes packedBytes(const Import& import, std::size_t view);

/// While it lives, packed views are kept until they have been read as often as was expected, so
/// that not all of a file is in memory packed, unpacked and read. What is read more often is
/// decoded anew.
class ExpectedReads {
  public:
    /// Decodes, on all cores, those of the accessors' views that are packed; each accessor is one
    /// read. Throws nothing: a fault is told to who reads the view.
    ExpectedReads(const Import& import, const std::vector<std::size_t>& accessors);
    ~ExpectedReads();
    ExpectedReads(const ExpectedReads&) = delete;
    ExpectedReads& operator=(const ExpectedReads&) = delete;

  private:
    const Import& import_;
};

}  // namespace ribalta::gltf
