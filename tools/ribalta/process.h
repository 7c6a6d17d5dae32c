// The command as a process: its signals and standard streams, its time and memory. Knows nothing of
// pictures.
#pragma once

#include <cstdint>

namespace ribalta {

/// To be called first in main. A stream that was closed is opened on nothing, so that no output
/// file takes its number; a file size limit becomes a failed write; interrupts, and a reader that
/// goes away, end the process as usual, but leave no temporary file behind.
void prepareProcess();

/// Wall time since the process was started, in ms, to a hundredth of a second.
double processMs();

/// The most memory it has had, in bytes.
std::uint64_t peakMemoryBytes();

/// Throws Error(kJobFailed) where what went to stdout was not all written.
void finishStdout();

}  // namespace ribalta
