#include "gl/available_texture_memory.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include <epoxy/gl.h>

#include "base/available_memory.h"
#include "gl/context.h"

namespace ribalta {

std::optional<std::uint64_t> availableTextureMemory() {
    // First: Mesa's software renderer has the extensions too, and fills them with anything.
    if (isSoftwareRenderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER)))) {
        return availableMemory();
    }
    constexpr std::uint64_t kKilobyte = 1024;
    if (epoxy_has_gl_extension("GL_ATI_meminfo")) {
        // The GPU's own pool, and the main memory that it may use besides.
        std::array<GLint, 4> free{};
        glGetIntegerv(GL_TEXTURE_FREE_MEMORY_ATI, free.data());
        const std::int64_t sum = std::int64_t(free[0]) + std::max(free[2], 0);
        return sum > 0 ? std::optional<std::uint64_t>(std::uint64_t(sum) * kKilobyte)
                       : std::nullopt;
    }
    if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info")) {
        GLint available = 0;
        glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, &available);
        return available > 0 ? std::optional<std::uint64_t>(std::uint64_t(available) * kKilobyte)
                             : std::nullopt;
    }
    return std::nullopt;
}

}  // namespace ribalta
