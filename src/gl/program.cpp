#include "gl/program.h"

#include <cstdio>

#include "base/check.h"
#include "gl/counters.h"
#include "gl/shader_library.h"

namespace ribalta {
namespace {

GLenum stageOf(const std::string& file) {
    if (file.ends_with(".vert")) {
        return GL_VERTEX_SHADER;
    }
    if (file.ends_with(".frag")) {
        return GL_FRAGMENT_SHADER;
    }
    CHECK(file.ends_with(".comp"));
    return GL_COMPUTE_SHADER;
}

GLuint compile(const std::string& file, const std::vector<std::string>& defines) {
    const ShaderSource source = assembleShader(file, defines);
    const GLuint shader = glCreateShader(stageOf(file));
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE) {
        std::string log(8192, '\0');
        glGetShaderInfoLog(shader, GLsizei(log.size()), nullptr, log.data());
        std::fprintf(stderr, "%s: does not compile:\n%s\n", file.c_str(), log.c_str());
        for (std::size_t i = 0; i < source.files.size(); ++i) {
            std::fprintf(stderr, "source %zu is %s\n", i, source.files[i].c_str());
        }
    }
    CHECK(compiled == GL_TRUE);
    return shader;
}

}  // namespace

Program::Program(const std::vector<std::string>& files, const std::vector<std::string>& defines)
    : handle_(glCreateProgram()) {
    for (const std::string& file : files) {
        const GLuint shader = compile(file, defines);
        glAttachShader(name(), shader);
        glDeleteShader(shader);
    }
    glLinkProgram(name());
    GLint linked = GL_FALSE;
    glGetProgramiv(name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) {
        std::string log(8192, '\0');
        glGetProgramInfoLog(name(), GLsizei(log.size()), nullptr, log.data());
        std::fprintf(stderr, "%s: does not link:\n%s\n", files.front().c_str(), log.c_str());
    }
    CHECK(linked == GL_TRUE);
    glObjectLabel(GL_PROGRAM, name(), GLsizei(files.front().size()), files.front().c_str());
    ++glCounters().programsBuilt;
}

void Program::setInt(GLint location, int value) const {
    glProgramUniform1i(name(), location, value);
}

}  // namespace ribalta
