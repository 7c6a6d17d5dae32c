#include "gl/texture_format.h"

#include "base/check.h"

namespace ribalta {

std::size_t bytesPerTexel(GLenum format) {
    switch (format) {
        case GL_RGBA32F:
            return 16;
        case GL_RGBA16F:
        case GL_RG32F:
            return 8;
        case GL_R8:
            return 1;
        case GL_RGBA8:
        case GL_SRGB8_ALPHA8:
        case GL_DEPTH_COMPONENT32F:
        case GL_R32F:
            return 4;
        default:
            CHECK(false && "a texture format without a known size");
            return 0;
    }
}

}  // namespace ribalta
