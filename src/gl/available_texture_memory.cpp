#include "gl/available_texture_memory.h"

#include <array>
#include <string_view>

#include <epoxy/gl.h>

#include "base/available_memory.h"
#include "gl/context.h"

namespace ribalta {

std::optional<std::uint64_t> availableTextureMemory() {
    // In kilobytes.
    if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info")) {
        GLint available = 0;
        glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, &available);
        return std::uint64_t(available) * 1024;
    }
    if (epoxy_has_gl_extension("GL_ATI_meminfo")) {
        std::array<GLint, 4> free{};
        glGetIntegerv(GL_TEXTURE_FREE_MEMORY_ATI, free.data());
        return std::uint64_t(free.front()) * 1024;
    }
    if (isSoftwareRenderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER)))) {
        return availableMemory();
    }
    return std::nullopt;
}

}  // namespace ribalta
