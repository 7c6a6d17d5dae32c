// Texture: immutable 2-D textures and arrays of them.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "gl/handle.h"

namespace ribalta {

inline void deleteTexture(GLuint name) {
    glDeleteTextures(1, &name);
}

class Texture2D {
  public:
    struct Size {
        int width = 0;
        int height = 0;
        int layers = 0;  ///< 0: a plain 2-D texture; otherwise an array of that many layers
        int levels = 1;
    };

    Texture2D() = default;
    /// `format` is a sized internal format, e.g. GL_RGBA32F. Throws Error(kJobFailed) where it is
    /// too large for the driver or its memory.
    Texture2D(const std::string& label, GLenum format, const Size& size);
    ~Texture2D();
    Texture2D(Texture2D&& other) noexcept;
    Texture2D& operator=(Texture2D&& other) noexcept;
    Texture2D(const Texture2D&) = delete;
    Texture2D& operator=(const Texture2D&) = delete;

    /// Writes the whole of level 0 of a layer, R, G, B, A, rows as the caller's convention has
    /// them; `type` is GL_UNSIGNED_BYTE or GL_FLOAT.
    void write(int layer, GLenum type, const void* pixels);
    void makeMipmaps();
    void setSampling(GLenum minify, GLenum magnify, GLenum wrapS, GLenum wrapT);
    /// Reads the whole of level 0 of a plain texture; waits for the GPU.
    void read(GLenum format, GLenum type, std::span<std::byte> bytes) const;
    /// The same of one layer of an array.
    void readLayer(int layer, GLenum format, GLenum type, std::span<std::byte> bytes) const;

    GLuint name() const { return handle_.name(); }
    const Size& size() const { return size_; }
    explicit operator bool() const { return bool(handle_); }

    /// Levels down to one texel.
    static int fullLevels(int width, int height);

  private:
    Handle<deleteTexture> handle_;
    Size size_;
    std::size_t bytes_ = 0;
};

}  // namespace ribalta
