// The bytes behind buffers and buffer views, bounds-checked.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/report.h"
#include "gltf/import.h"

namespace ribalta::gltf {

/// Reads or decodes every buffer; `bin` is the GLB's binary chunk and must outlive the result.
/// Buffers that only stand in for packed views stay empty. Of `import` neither model nor buffers
/// are used. Files are found as findUri does. Throws Error(kBadInput) where one is missing or
/// shorter than its byteLength, LimitError where they are too much.
std::vector<Buffer> readBuffers(const Import& import, std::optional<std::span<const std::byte>> bin,
                                Report& report);

/// The bytes of a buffer view, unpacked where it is packed. Throws Error(kBadInput) where it
/// reaches past its buffer or the file gives that buffer no data. They may lie in a file that
/// another program writes to: each is to be looked at once.
ViewBytes viewBytes(const Import& import, std::size_t bufferView);

/// A copy of the same, for decoders, which check what they look at again.
std::vector<std::byte> copyOfView(const Import& import, std::size_t bufferView);

}  // namespace ribalta::gltf
