// OpenGL's own complaints: any error fails loudly, where it happens.
#pragma once

#include <string>
#include <vector>

namespace ribalta {

/// Routes the driver's messages here; errors and undefined behaviour are printed and kept.
void installDebugOutput();

/// The errors since the start or since the last call, and forgets them.
std::vector<std::string> takeGlErrors();

/// Names a stretch of commands for debuggers and captures while it lives.
class DebugGroup {
  public:
    explicit DebugGroup(const char* name);
    ~DebugGroup();
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
};

}  // namespace ribalta
