#include "gl/texture_3d.h"

#include <algorithm>

#include "base/error.h"
#include "gl/counters.h"
#include "gl/texture_format.h"

namespace ribalta {
namespace {

std::string describe(const Texture3D::Size& size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height) + "x" +
           std::to_string(size.depth) + " texels";
}

}  // namespace

Texture3D::Texture3D(const std::string& label, GLenum format, const Size& size)
    : size_(size),
      bytes_(bytesPerTexel(format) * std::size_t(size.width) * std::size_t(size.height) *
             std::size_t(size.depth)) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limit);
    if (std::max({size.width, size.height, size.depth}) > limit) {
        throw Error(ErrorKind::kJobFailed, {},
                    label + ": " + describe(size) + " are more than this OpenGL's " +
                        std::to_string(limit) + " a side; ask for a smaller table");
    }
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_3D, 1, &name);
    handle_ = Handle<deleteTexture>(name);
    glTextureStorage3D(name, 1, format, size.width, size.height, size.depth);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        throw Error(ErrorKind::kJobFailed, {},
                    label + ": no memory on the GPU for " + describe(size) + ", " +
                        std::to_string(bytes_ >> 20U) + " MB; ask for a smaller table");
    }
    glObjectLabel(GL_TEXTURE, name, GLsizei(label.size()), label.c_str());
    for (const GLenum direction : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTextureParameteri(name, direction, GL_CLAMP_TO_EDGE);
    }
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    countAllocation(bytes_);
    ++glCounters().texturesMade;
}

Texture3D::~Texture3D() {
    countRelease(bytes_);
}

Texture3D::Texture3D(Texture3D&& other) noexcept
    : handle_(std::move(other.handle_)),
      size_(other.size_),
      bytes_(std::exchange(other.bytes_, 0)) {}

Texture3D& Texture3D::operator=(Texture3D&& other) noexcept {
    std::swap(handle_, other.handle_);
    std::swap(size_, other.size_);
    std::swap(bytes_, other.bytes_);
    return *this;
}

void Texture3D::read(GLenum format, GLenum type, std::span<std::byte> bytes) const {
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(name(), 0, format, type, GLsizei(bytes.size()), bytes.data());
}

}  // namespace ribalta
