// Framebuffer: a set of textures that draws go to.
#pragma once

#include <initializer_list>
#include <string>

#include "gl/handle.h"
#include "gl/texture.h"

namespace ribalta {

inline void deleteFramebuffer(GLuint name) {
    glDeleteFramebuffers(1, &name);
}

class Framebuffer {
  public:
    Framebuffer() = default;
    /// Colour outputs 0, 1, ... in the order given; null ones are left out together with their
    /// output. The textures must outlive the framebuffer.
    Framebuffer(const std::string& label, std::initializer_list<const Texture2D*> colors,
                const Texture2D* depth);
    /// Depth only, one layer of an array.
    Framebuffer(const std::string& label, const Texture2D& depthArray, int layer);

    /// Makes it the target of draws and sets the viewport to its size.
    void bind() const;
    GLuint name() const { return handle_.name(); }

  private:
    void finish(const std::string& label);

    Handle<deleteFramebuffer> handle_;
    int width_ = 0;
    int height_ = 0;
};

}  // namespace ribalta
