// Handle: sole ownership of one OpenGL object name.
#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace ribalta {

/// Deletes its name on destruction; needs the context that made it to be current then.
template <void (*Delete)(GLuint)>
class Handle {
  public:
    Handle() = default;
    explicit Handle(GLuint name) : name_(name) {}
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

  private:
    void reset() {
        if (name_ != 0) {
            Delete(name_);
        }
    }

    GLuint name_ = 0;
};

}  // namespace ribalta
