#include "gl/texture.h"

#include <algorithm>
#include <bit>

#include "base/error.h"
#include "gl/counters.h"
#include "gl/texture_format.h"

namespace ribalta {

Texture2D::Texture2D(const std::string& label, GLenum format, const Size& size) : size_(size) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (std::max(size.width, size.height) > limit) {
        throw Error(ErrorKind::kJobFailed, {},
                    label + ": " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                        " pixels are more than this OpenGL's " + std::to_string(limit) +
                        " a side; ask for a smaller picture");
    }
    GLuint name = 0;
    if (size.layers > 0) {
        glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
        glTextureStorage3D(name, size.levels, format, size.width, size.height, size.layers);
    } else {
        glCreateTextures(GL_TEXTURE_2D, 1, &name);
        glTextureStorage2D(name, size.levels, format, size.width, size.height);
    }
    handle_ = Handle<deleteTexture>(name);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        throw Error(ErrorKind::kJobFailed, {},
                    label + ": no memory on the GPU for " + std::to_string(size.width) + "x" +
                        std::to_string(size.height) + " pixels; ask for a smaller picture");
    }
    glObjectLabel(GL_TEXTURE, name, GLsizei(label.size()), label.c_str());

    for (int level = 0; level < size.levels; ++level) {
        bytes_ += bytesPerTexel(format) * std::size_t(std::max(1, size.width >> level)) *
                  std::size_t(std::max(1, size.height >> level)) *
                  std::size_t(std::max(1, size.layers));
    }
    countAllocation(bytes_);
    ++glCounters().texturesMade;
}

Texture2D::~Texture2D() {
    countRelease(bytes_);
}

Texture2D::Texture2D(Texture2D&& other) noexcept
    : handle_(std::move(other.handle_)),
      size_(other.size_),
      bytes_(std::exchange(other.bytes_, 0)) {}

Texture2D& Texture2D::operator=(Texture2D&& other) noexcept {
    std::swap(handle_, other.handle_);
    std::swap(size_, other.size_);
    std::swap(bytes_, other.bytes_);
    return *this;
}

void Texture2D::write(int layer, GLenum type, const void* pixels) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (size_.layers > 0) {
        glTextureSubImage3D(name(), 0, 0, 0, layer, size_.width, size_.height, 1, GL_RGBA, type,
                            pixels);
    } else {
        glTextureSubImage2D(name(), 0, 0, 0, size_.width, size_.height, GL_RGBA, type, pixels);
    }
}

void Texture2D::makeMipmaps() {
    glGenerateTextureMipmap(name());
}

void Texture2D::setSampling(GLenum minify, GLenum magnify, GLenum wrapS, GLenum wrapT) {
    glTextureParameteri(name(), GL_TEXTURE_MIN_FILTER, GLint(minify));
    glTextureParameteri(name(), GL_TEXTURE_MAG_FILTER, GLint(magnify));
    glTextureParameteri(name(), GL_TEXTURE_WRAP_S, GLint(wrapS));
    glTextureParameteri(name(), GL_TEXTURE_WRAP_T, GLint(wrapT));
}

void Texture2D::read(GLenum format, GLenum type, std::span<std::byte> bytes) const {
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(name(), 0, format, type, GLsizei(bytes.size()), bytes.data());
}

void Texture2D::readLayer(int layer, GLenum format, GLenum type, std::span<std::byte> bytes) const {
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureSubImage(name(), 0, 0, 0, layer, size_.width, size_.height, 1, format, type,
                         GLsizei(bytes.size()), bytes.data());
}

int Texture2D::fullLevels(int width, int height) {
    return int(std::bit_width(unsigned(std::max(width, height))));
}

}  // namespace ribalta
