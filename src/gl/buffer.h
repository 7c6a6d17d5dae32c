// Buffer: immutable-size GPU memory for vertices, uniforms and shader storage.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "gl/handle.h"

namespace ribalta {

inline void deleteBuffer(GLuint name) {
    glDeleteBuffers(1, &name);
}

class Buffer {
  public:
    Buffer() = default;
    /// Holds a copy of `bytes`; written once.
    Buffer(const std::string& label, std::span<const std::byte> bytes);
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    /// Replaces the content; memory is taken anew only where `bytes` does not fit.
    void write(const std::string& label, std::span<const std::byte> bytes);
    /// Copies the first bytes back; waits for the GPU.
    void read(std::span<std::byte> bytes) const;

    GLuint name() const { return handle_.name(); }
    std::size_t size() const { return size_; }

  private:
    Handle<deleteBuffer> handle_;
    std::size_t size_ = 0;
};

/// The bytes of a vector of plain values.
template <typename Container>
std::span<const std::byte> bytesOf(const Container& values) {
    return std::as_bytes(std::span(values));
}

}  // namespace ribalta
