// Texture3D: immutable volumes of texels, for tables that shaders interpolate in.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "gl/texture.h"

namespace ribalta {

/// One level, interpolated linearly, clamped to its edges.
class Texture3D {
  public:
    struct Size {
        int width = 0;
        int height = 0;
        int depth = 0;
    };

    Texture3D() = default;
    /// `format` is a sized internal format, e.g. GL_RGBA32F; the content is not defined. Throws
    /// Error(kJobFailed) where it is too large for the driver or its memory.
    Texture3D(const std::string& label, GLenum format, const Size& size);
    ~Texture3D();
    Texture3D(Texture3D&& other) noexcept;
    Texture3D& operator=(Texture3D&& other) noexcept;
    Texture3D(const Texture3D&) = delete;
    Texture3D& operator=(const Texture3D&) = delete;

    /// Reads the whole, rows by layers; waits for the GPU.
    void read(GLenum format, GLenum type, std::span<std::byte> bytes) const;

    GLuint name() const { return handle_.name(); }
    const Size& size() const { return size_; }
    std::size_t bytes() const { return bytes_; }
    explicit operator bool() const { return bool(handle_); }

  private:
    Handle<deleteTexture> handle_;
    Size size_;
    std::size_t bytes_ = 0;
};

}  // namespace ribalta
