// Memory that is freed and asked for again.
#pragma once

namespace ribalta {

/// Has the process keep what it frees for what it asks for next. By default the system is asked
/// anew for every large block, and has to find and clear its pages: a quarter of the time of
/// reading some scenes. To be called once, first.
void keepFreedMemory();

/// Gives back what has been kept: for a program that goes on when its large work is done.
void returnFreedMemory();

}  // namespace ribalta
