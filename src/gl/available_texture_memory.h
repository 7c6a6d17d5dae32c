// How much memory the current context has for textures that have yet to be made.
#pragma once

#include <cstdint>
#include <optional>

namespace ribalta {

/// Bytes: of the GPU, or of the system where that draws; none where neither says.
std::optional<std::uint64_t> availableTextureMemory();

}  // namespace ribalta
