// CHECK: our own bugs. Stays on in release; bad input is never CHECKed but thrown as Error.
#pragma once

namespace ribalta {

/// Prints the broken condition with its place in the source and aborts.
[[noreturn]] void checkFailed(const char* condition, const char* file, int line);

}  // namespace ribalta

#define CHECK(condition) \
    ((condition) ? void(0) : ::ribalta::checkFailed(#condition, __FILE__, __LINE__))
