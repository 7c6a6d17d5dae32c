// Window: a window of the desktop with an OpenGL 4.5 context, and Dear ImGui on top of it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

struct GLFWwindow;

namespace ribalta {

/// A key that went down, by GLFW's numbers.
struct KeyPress {
    int key = 0;
    bool control = false;
    bool shift = false;
};

class Window {
  public:
    /// Opens it; its context is current on this thread for as long as it lives. One a process, on
    /// the main thread. Throws Error(kNoOpenGL) where there is no display or no OpenGL 4.5 core,
    /// which names what can be done instead.
    Window(const std::string& title, glm::ivec2 size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// The driver's name of the renderer.
    const std::string& renderer() const { return renderer_; }

    void setTitle(const std::string& title);
    bool isClosing() const;
    void close();
    void hide();
    /// Pixels to draw; zero where the window is minimised or dragged to nothing.
    glm::ivec2 pixels() const;
    /// Pixels of the picture for one unit of the pointer's coordinates.
    glm::vec2 pixelScale() const;

    /// Handles what has come from the desktop, after waiting for it up to `seconds` (infinity: as
    /// long as it takes). Whether anything came.
    bool takeEvents(double seconds);
    /// Ends a wait for events. May be called from any thread.
    static void wake();
    /// Keys that went down since the last call, those that have been let go of again among them:
    /// Dear ImGui forgets what comes and goes within one frame.
    std::vector<KeyPress> takeKeys();
    /// Files dropped on the window since the last call.
    std::vector<std::filesystem::path> takeDropped();

    /// Starts a frame of Dear ImGui's.
    void beginFrame();
    /// Draws what Dear ImGui holds over `picture` (a framebuffer of `pictureSize` pixels; 0 for
    /// none), stretched to the window, and shows it.
    void showFrame(unsigned picture, glm::ivec2 pictureSize);

  private:
    struct Glfw;
    void setUpInterface();

    std::unique_ptr<Glfw> glfw_;
    GLFWwindow* window_ = nullptr;
    std::string renderer_;
    unsigned events_ = 0;
    unsigned taken_ = 0;  ///< events and wakes that takeEvents() has told of
    std::vector<KeyPress> keys_;
    std::vector<std::filesystem::path> dropped_;
};

}  // namespace ribalta
