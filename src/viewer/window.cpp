#include "viewer/window.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include <epoxy/gl.h>
// After epoxy: GLFW brings OpenGL's own header otherwise.
#include <GLFW/glfw3.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_opengl3.h>
#include <imgui/imgui.h>

#include "base/error.h"
#include "gl/debug_output.h"
#include "gl/prepare_context.h"

namespace ribalta {
namespace {

constexpr const char* kInstead = "; `ribalta render` draws pictures without a window";
constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float kFontPixels = 15.0F;

// Calls of Window::wake(), which no callback of GLFW's tells of.
std::atomic<unsigned> wakes = 0;

// The last thing that GLFW said was wrong.
std::string& complaint() {
    static std::string text;
    return text;
}

[[noreturn]] void refuse(const std::string& what) {
    throw Error(ErrorKind::kNoOpenGL, {}, what + kInstead);
}

// The newest version of OpenGL that a window can have here, as text; empty: none at all.
std::string versionThereIs() {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    GLFWwindow* trial = glfwCreateWindow(16, 16, "ribalta", nullptr, nullptr);
    if (trial == nullptr) {
        return {};
    }
    glfwMakeContextCurrent(trial);
    const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    std::string text = version == nullptr ? "" : version;
    glfwDestroyWindow(trial);
    return text;
}

GLFWwindow* open(const std::string& title, glm::ivec2 size) {
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    GLFWwindow* window = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (window == nullptr) {
        const std::string why = complaint();
        const std::string there = versionThereIs();
        refuse("no window with OpenGL 4.5 core: " +
               (there.empty() ? why : "this display has " + there));
    }
    return window;
}

}  // namespace

struct Window::Glfw {
    Glfw() {
        glfwSetErrorCallback(
            [](int /*code*/, const char* description) { complaint() = description; });
        if (glfwInit() == GLFW_FALSE) {
            refuse("no display to open a window on: " + complaint());
        }
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

Window::Window(const std::string& title, glm::ivec2 size)
    : glfw_(std::make_unique<Glfw>()), window_(open(title, size)) {
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    prepareContext();
    renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    setUpInterface();
}

void Window::setUpInterface() {
    // Before Dear ImGui's own, which hand on what they get.
    glfwSetWindowUserPointer(window_, this);
    static const auto self = [](GLFWwindow* window) {
        return static_cast<Window*>(glfwGetWindowUserPointer(window));
    };
    static const auto count = [](GLFWwindow* window) { ++self(window)->events_; };
    glfwSetDropCallback(window_, [](GLFWwindow* window, int files, const char** paths) {
        self(window)->dropped_.insert(self(window)->dropped_.end(), paths, paths + files);
        count(window);
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int modifiers) {
        if (action == GLFW_PRESS) {
            self(w)->keys_.push_back(
                {key, (modifiers & GLFW_MOD_CONTROL) != 0, (modifiers & GLFW_MOD_SHIFT) != 0});
        }
        count(w);
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { count(w); });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { count(w); });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { count(w); });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { count(w); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { count(w); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { count(w); });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { count(w); });

    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    if (std::filesystem::exists(kFont)) {
        io.Fonts->AddFontFromFileTTF(kFont, kFontPixels);
    }
    ImGui::StyleColorsDark();
    ImGui::GetStyle().WindowRounding = 4.0F;
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

bool Window::isClosing() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::hide() {
    glfwHideWindow(window_);
    glfwPollEvents();
}

void Window::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

glm::ivec2 Window::pixels() const {
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

glm::vec2 Window::pixelScale() const {
    glm::ivec2 size(0);
    glfwGetWindowSize(window_, &size.x, &size.y);
    return glm::vec2(pixels()) / glm::vec2(glm::max(size, glm::ivec2(1)));
}

bool Window::takeEvents(double seconds) {
    if (!(seconds > 0.0)) {
        glfwPollEvents();
    } else if (std::isinf(seconds)) {
        glfwWaitEvents();
    } else {
        glfwWaitEventsTimeout(seconds);
    }
    const unsigned now = events_ + wakes;
    return std::exchange(taken_, now) != now;
}

void Window::wake() {
    ++wakes;
    glfwPostEmptyEvent();
}

std::vector<KeyPress> Window::takeKeys() {
    return std::exchange(keys_, {});
}

std::vector<std::filesystem::path> Window::takeDropped() {
    return std::exchange(dropped_, {});
}

void Window::beginFrame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Window::showFrame(unsigned picture, glm::ivec2 pictureSize) {
    ImGui::Render();
    const glm::ivec2 size = pixels();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.x, size.y);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (picture == 0) {
        const float dark[] = {0.02F, 0.02F, 0.02F, 1.0F};
        glClearBufferfv(GL_COLOR, 0, dark);
    } else if (size.x > 0 && size.y > 0) {
        glDisable(GL_SCISSOR_TEST);
        glBlitNamedFramebuffer(picture, 0, 0, 0, pictureSize.x, pictureSize.y, 0, 0, size.x, size.y,
                               GL_COLOR_BUFFER_BIT, pictureSize == size ? GL_NEAREST : GL_LINEAR);
    }
    // Dear ImGui puts the program in use back afterwards, which may be gone by then.
    glUseProgram(0);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
}

}  // namespace ribalta
