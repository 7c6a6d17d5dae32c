// Context: a headless OpenGL 4.5 core context through EGL; no display or window system needed.
#pragma once

#include <memory>
#include <string>

namespace ribalta {

/// Whether a renderer of that name draws with the system's processors.
bool isSoftwareRenderer(const std::string& renderer);

/// Current on the thread that made it, for as long as it lives. One a process.
class Context {
  public:
    /// Takes the first GPU that offers OpenGL 4.5 core, or else Mesa's software renderer.
    /// Throws Error(kNoOpenGL) that says what was tried and what to install.
    Context();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// The driver's name of the renderer, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
    const std::string& renderer() const { return renderer_; }
    const std::string& version() const { return version_; }
    bool isSoftware() const { return software_; }

  private:
    struct Egl;
    std::unique_ptr<Egl> egl_;
    std::string renderer_;
    std::string version_;
    bool software_ = false;
};

}  // namespace ribalta
