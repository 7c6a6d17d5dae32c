// Program: a linked set of shaders.
#pragma once

#include <string>
#include <vector>

#include "gl/handle.h"

namespace ribalta {

inline void deleteProgram(GLuint name) {
    glDeleteProgram(name);
}

class Program {
  public:
    Program() = default;
    /// Builds from the shader library's files, e.g. {"passes/forward.vert", "passes/forward.frag"};
    /// the stage follows from the ending (.vert, .frag, .comp). `defines` are names switched on.
    /// Throws Error(kBadInput) at the first line that does not compile, with what the compiler
    /// says.
    Program(const std::vector<std::string>& files, const std::vector<std::string>& defines = {});

    GLuint name() const { return handle_.name(); }
    explicit operator bool() const { return bool(handle_); }

    void setInt(GLint location, int value) const;

  private:
    Handle<deleteProgram> handle_;
};

}  // namespace ribalta
