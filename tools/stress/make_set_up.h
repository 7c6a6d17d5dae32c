// The generator of the stress test's cases: ordinary set-ups, and the corners where beams are hard
// to draw. A case follows from its seed and number alone.
#pragma once

#include <span>

#include "set_up.h"

namespace ribalta::stress {

/// The classes of set-ups; case n is of class n modulo their number.
std::span<const char* const> kindNames();

SetUp makeSetUp(std::uint64_t seed, int number);

}  // namespace ribalta::stress
