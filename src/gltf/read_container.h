// The outer shell of a file: plain .gltf or the chunks of a binary .glb (glTF 2.0, section 4).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "base/error.h"

namespace ribalta::gltf {

/// Views into a file's bytes.
struct Container {
    std::string_view json;                          ///< UTF-8, without a byte order mark
    std::optional<std::span<const std::byte>> bin;  ///< a GLB's binary chunk
};

/// Splits a file. Throws Error(kBadInput) where it is empty, truncated, of another container
/// version, or neither JSON nor GLB.
Container readContainer(std::span<const std::byte> bytes, const Place& file);

}  // namespace ribalta::gltf
