// Buffer: immutable-size GPU memory for vertices, uniforms and shader storage.
#pragma once

#include <cstddef>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <vector>

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
    /// The same of `size` bytes, without a copy of them here: `write` sets all of what it is given,
    /// from any threads, and reads none of it; it may be called again. Throws Error(kJobFailed)
    /// where there is no memory.
    void fill(const std::string& label, std::size_t size,
              const std::function<void(std::span<std::byte>)>& write);
    /// Makes room for `size` bytes; the content is lost where memory is taken anew.
    void reserve(const std::string& label, std::size_t size);
    /// Shows shaders element `index` of a buffer of spreadForUniforms in a uniform block.
    void bindUniform(int slot, int index) const;
    /// Copies the first bytes back; waits for the GPU.
    void read(std::span<std::byte> bytes) const;

    GLuint name() const { return handle_.name(); }
    std::size_t size() const { return size_; }

  private:
    Handle<deleteBuffer> handle_;
    std::size_t size_ = 0;
};

/// Distance between the elements of a buffer of which shaders see one at a time through a uniform
/// block: the largest alignment OpenGL may ask for.
inline constexpr std::size_t kUniformStride = 256;

/// Puts each value at a multiple of kUniformStride.
template <typename Value>
std::vector<std::byte> spreadForUniforms(const std::vector<Value>& values) {
    static_assert(sizeof(Value) <= kUniformStride);
    std::vector<std::byte> bytes(values.size() * kUniformStride);
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::memcpy(&bytes[i * kUniformStride], &values[i], sizeof(Value));
    }
    return bytes;
}

/// The bytes of a vector of plain values.
template <typename Container>
std::span<const std::byte> bytesOf(const Container& values) {
    return std::as_bytes(std::span(values));
}

}  // namespace ribalta
