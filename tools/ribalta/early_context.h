// EarlyContext: OpenGL, started while a scene is read.
#pragma once

#include <exception>
#include <optional>

#include "gl/context.h"

namespace ribalta {

/// What is wrong with OpenGL is said when it is asked for, so that what is wrong with the scene
/// goes before it.
class EarlyContext {
  public:
    EarlyContext();

    /// Current in the thread that made this. Throws Error(kNoOpenGL).
    const Context& get() const;
    /// Wall time that its start took.
    double ms() const { return ms_; }

  private:
    std::optional<Context> context_;
    std::exception_ptr fault_;
    double ms_ = 0.0;
};

}  // namespace ribalta
