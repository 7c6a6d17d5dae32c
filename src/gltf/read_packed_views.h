// Buffer views that EXT_meshopt_compression packs: decoded once, when they are first asked for.
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

/// One packed view. Filled by whichever thread asks first.
struct PackedView {
    std::once_flag once;
    std::vector<std::byte> bytes;
    std::exception_ptr fault;  ///< why there are no bytes
};

/// By buffer view; null where it is plain. Empty where none is packed.
using PackedViews = std::vector<std::unique_ptr<PackedView>>;

/// Finds the packed views of a document; decodes nothing.
PackedViews findPackedViews(const nlohmann::json& root);

/// By buffer: whether it only stands in for packed views, for readers without the extension.
std::vector<char> findFallbackBuffers(const nlohmann::json& root);

bool isPacked(const Import& import, std::size_t view);

/// The decoded bytes of a packed view, as long as the import lives. Safe from several threads.
/// Throws Error(kBadInput).
std::span<const std::byte> packedBytes(const Import& import, std::size_t view);

/// Decodes, on all cores, those of the accessors' views that are packed. Throws nothing: a fault is
/// told to who reads the view.
void unpackViews(const Import& import, const std::vector<std::size_t>& accessors);

}  // namespace ribalta::gltf
