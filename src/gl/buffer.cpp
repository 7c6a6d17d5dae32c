#include "gl/buffer.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"
#include "gl/counters.h"

namespace ribalta {

Buffer::Buffer(const std::string& label, std::span<const std::byte> bytes) {
    write(label, bytes);
}

Buffer::~Buffer() {
    countRelease(size_);
}

Buffer::Buffer(Buffer&& other) noexcept
    : handle_(std::move(other.handle_)), size_(std::exchange(other.size_, 0)) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(handle_, other.handle_);
    std::swap(size_, other.size_);
    return *this;
}

void Buffer::write(const std::string& label, std::span<const std::byte> bytes) {
    reserve(label, bytes.size());
    if (!bytes.empty()) {
        glNamedBufferSubData(handle_.name(), 0, GLsizeiptr(bytes.size()), bytes.data());
    }
}

void Buffer::fill(const std::string& label, std::size_t size,
                  const std::function<void(std::span<std::byte>)>& write) {
    reserve(label, size);
    if (size == 0) {
        return;
    }
    // The driver may lose what was written, as when a screen's mode changes (OpenGL 4.5, 6.3.1).
    for (bool isKept = false; !isKept;) {
        void* const start = glMapNamedBufferRange(handle_.name(), 0, GLsizeiptr(size),
                                                  GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
        if (start == nullptr) {
            throw Error(ErrorKind::kJobFailed, {},
                        label + ": no memory on the GPU for " + std::to_string(size) +
                            " bytes; leave something out of the scene");
        }
        write({static_cast<std::byte*>(start), size});
        isKept = glUnmapNamedBuffer(handle_.name()) == GL_TRUE;
    }
}

void Buffer::reserve(const std::string& label, std::size_t size) {
    if (handle_ && size <= size_) {
        return;
    }
    GLuint name = 0;
    glCreateBuffers(1, &name);
    handle_ = Handle<deleteBuffer>(name);
    countRelease(size_);
    // A buffer of no bytes is an error in OpenGL, and an empty list is none here.
    size_ = std::max<std::size_t>(size, 16);
    countAllocation(size_);
    glNamedBufferStorage(name, GLsizeiptr(size_), nullptr,
                         GL_DYNAMIC_STORAGE_BIT | GL_MAP_WRITE_BIT);
    glObjectLabel(GL_BUFFER, name, GLsizei(label.size()), label.c_str());
}

void Buffer::bindUniform(int slot, int index) const {
    glBindBufferRange(GL_UNIFORM_BUFFER, GLuint(slot), handle_.name(),
                      GLintptr(std::size_t(index) * kUniformStride), GLsizeiptr(kUniformStride));
}

void Buffer::read(std::span<std::byte> bytes) const {
    CHECK(bytes.size() <= size_);
    glGetNamedBufferSubData(handle_.name(), 0, GLsizeiptr(bytes.size()), bytes.data());
}

}  // namespace ribalta
