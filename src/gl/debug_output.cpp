#include "gl/debug_output.h"

#include <cstdio>
#include <utility>

#include <epoxy/gl.h>

namespace ribalta {
namespace {

std::vector<std::string>& errors() {
    static std::vector<std::string> list;
    return list;
}

void GLAPIENTRY onMessage(GLenum source, GLenum type, GLuint /*id*/, GLenum /*severity*/,
                          GLsizei length, const GLchar* message, const void* /*user*/) {
    if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) {
        return;
    }
    // What a shader's compiler finds wrong is told by whoever compiles, as an Error.
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) {
        return;
    }
    errors().emplace_back(message, std::size_t(length));
    // Memory that is not there is told by whoever asked for it, as an Error.
    if (errors().back().find("GL_OUT_OF_MEMORY") != std::string::npos) {
        return;
    }
    std::fprintf(stderr, "ribalta: OpenGL error: %s\n", errors().back().c_str());
}

}  // namespace

void installDebugOutput() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, nullptr);
}

std::vector<std::string> takeGlErrors() {
    return std::exchange(errors(), {});
}

DebugGroup::DebugGroup(const char* name) {
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
}

DebugGroup::~DebugGroup() {
    glPopDebugGroup();
}

}  // namespace ribalta
