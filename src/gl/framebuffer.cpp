#include "gl/framebuffer.h"

#include <vector>

#include "base/check.h"
#include "gl/counters.h"

namespace ribalta {
namespace {

GLuint createFramebuffer() {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return name;
}

}  // namespace

Framebuffer::Framebuffer(const std::string& label, std::initializer_list<const Texture2D*> colors,
                         const Texture2D* depth)
    : handle_(createFramebuffer()) {
    std::vector<GLenum> outputs;
    for (const Texture2D* color : colors) {
        const auto attachment = GLenum(GL_COLOR_ATTACHMENT0 + outputs.size());
        outputs.push_back(color != nullptr ? attachment : GLenum(GL_NONE));
        if (color != nullptr) {
            glNamedFramebufferTexture(name(), attachment, color->name(), 0);
            width_ = color->size().width;
            height_ = color->size().height;
        }
    }
    glNamedFramebufferDrawBuffers(name(), GLsizei(outputs.size()), outputs.data());
    if (depth != nullptr) {
        glNamedFramebufferTexture(name(), GL_DEPTH_ATTACHMENT, depth->name(), 0);
        width_ = depth->size().width;
        height_ = depth->size().height;
    }
    finish(label);
}

Framebuffer::Framebuffer(const std::string& label, const Texture2D& depthArray, int layer)
    : handle_(createFramebuffer()),
      width_(depthArray.size().width),
      height_(depthArray.size().height) {
    glNamedFramebufferTextureLayer(name(), GL_DEPTH_ATTACHMENT, depthArray.name(), 0, layer);
    glNamedFramebufferDrawBuffer(name(), GL_NONE);
    finish(label);
}

void Framebuffer::finish(const std::string& label) {
    glObjectLabel(GL_FRAMEBUFFER, name(), GLsizei(label.size()), label.c_str());
    CHECK(glCheckNamedFramebufferStatus(name(), GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    ++glCounters().framebuffersMade;
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    glViewport(0, 0, width_, height_);
}

}  // namespace ribalta
