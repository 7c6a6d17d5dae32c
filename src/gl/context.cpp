#include "gl/context.h"

#include <cstring>
#include <vector>

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "base/error.h"
#include "base/log.h"
#include "gl/prepare_context.h"

namespace ribalta {

struct Context::Egl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    Egl() = default;
    Egl(const Egl&) = delete;
    Egl& operator=(const Egl&) = delete;
    ~Egl() {
        if (display == EGL_NO_DISPLAY) {
            return;
        }
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) {
            eglDestroyContext(display, context);
        }
        eglTerminate(display);
    }

    /// Whether `candidate` gave a current OpenGL 4.5 core context; otherwise `why` says what
    /// failed.
    bool open(EGLDisplay candidate, std::string& why);
};

bool Context::Egl::open(EGLDisplay candidate, std::string& why) {
    if (candidate == EGL_NO_DISPLAY || eglInitialize(candidate, nullptr, nullptr) == EGL_FALSE) {
        why = "EGL does not start";
        return false;
    }
    display = candidate;
    // A context without a configuration: all drawing goes to framebuffer objects.
    constexpr EGLint kAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                      4,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      5,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_CONTEXT_OPENGL_DEBUG,
                                      EGL_TRUE,
                                      EGL_NONE};
    if (eglBindAPI(EGL_OPENGL_API) == EGL_TRUE) {
        context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes);
    }
    if (context != EGL_NO_CONTEXT &&
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) {
        return true;
    }
    why = "no OpenGL 4.5 core context";
    return false;
}

namespace {

bool isSoftwareDevice(EGLDeviceEXT device) {
    const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    return extensions != nullptr && std::strstr(extensions, "EGL_MESA_device_software") != nullptr;
}

// Every display worth a try, GPUs first, the software renderer last.
std::vector<EGLDisplay> candidateDisplays() {
    std::vector<EGLDisplay> hardware;
    std::vector<EGLDisplay> software;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
        EGLDeviceEXT devices[32];
        EGLint count = 0;
        if (eglQueryDevicesEXT(32, devices, &count) == EGL_TRUE) {
            for (int i = 0; i < count; ++i) {
                (isSoftwareDevice(devices[i]) ? software : hardware)
                    .push_back(
                        eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
            }
        }
    }
    hardware.insert(hardware.end(), software.begin(), software.end());
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        hardware.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
    }
    return hardware;
}

bool libraryIsThere(const char* name) {
    void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr) {
        return false;
    }
    dlclose(library);
    return true;
}

constexpr const char* kCure =
    "install a GPU driver with EGL, or Mesa's software renderer (Debian: libegl1 "
    "libegl-mesa0 libgl1-mesa-dri libopengl0)";

}  // namespace

bool isSoftwareRenderer(const std::string& renderer) {
    return renderer.find("llvmpipe") != std::string::npos ||
           renderer.find("softpipe") != std::string::npos ||
           renderer.find("swrast") != std::string::npos;
}

Context::Context() {
    // libepoxy ends the process where a library is missing, so look first.
    for (const char* library : {"libEGL.so.1", "libOpenGL.so.0"}) {
        if (!libraryIsThere(library)) {
            throw Error(ErrorKind::kNoOpenGL, {},
                        std::string("no usable OpenGL: ") + library + " is missing; " + kCure);
        }
    }
    std::string tried;
    for (EGLDisplay display : candidateDisplays()) {
        auto egl = std::make_unique<Egl>();
        std::string why;
        if (egl->open(display, why)) {
            egl_ = std::move(egl);
            break;
        }
        logVerbose("OpenGL: passed over a device: " + why);
        if (tried.find(why) == std::string::npos) {
            tried += (tried.empty() ? "" : ", ") + why;
        }
    }
    if (!egl_) {
        throw Error(ErrorKind::kNoOpenGL, {},
                    "no usable OpenGL 4.5: " +
                        (tried.empty() ? "EGL offers no headless device" : tried) + "; " + kCure);
    }
    renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    version_ = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    software_ = isSoftwareRenderer(renderer_);
    prepareContext();
}

Context::~Context() = default;

}  // namespace ribalta
