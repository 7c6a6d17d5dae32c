// How much memory there is for what has yet to be made; for messages and refusals beforehand, since
// a system may grant more than it has and end the program later.
#pragma once

#include <cstdint>
#include <optional>

namespace ribalta {

/// Bytes that the system, and the group of processes it puts this one in, can still give; none
/// where it does not say.
std::optional<std::uint64_t> availableMemory();

}  // namespace ribalta
