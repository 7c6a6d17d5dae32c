#include "gl/program.h"

#include <chrono>
#include <cstdio>

#include "base/check.h"
#include "base/error.h"
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

// Where the first message points: drivers begin it with the number that #line gave, and the line
// ("3:12(8): error", "3(12) : error").
Place placeOf(const std::string& log, const ShaderSource& source, const std::string& file) {
    std::size_t number = 0;
    unsigned line = 0;
    if (std::sscanf(log.c_str(), "%zu%*[:(]%u", &number, &line) == 2 &&
        number < source.files.size()) {
        return {source.files[number], "line " + std::to_string(line)};
    }
    return {file, ""};
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
        GLsizei length = 0;
        std::string log(8192, '\0');
        glGetShaderInfoLog(shader, GLsizei(log.size()), &length, log.data());
        log.resize(std::size_t(length));
        glDeleteShader(shader);
        throw Error(ErrorKind::kBadInput, placeOf(log, source, file), "does not compile: " + log);
    }
    return shader;
}

}  // namespace

Program::Program(const std::vector<std::string>& files, const std::vector<std::string>& defines)
    : handle_(glCreateProgram()) {
    const auto start = std::chrono::steady_clock::now();
    for (const std::string& file : files) {
        const GLuint shader = compile(file, defines);
        glAttachShader(name(), shader);
        glDeleteShader(shader);
    }
    glLinkProgram(name());
    GLint linked = GL_FALSE;
    glGetProgramiv(name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) {
        GLsizei length = 0;
        std::string log(8192, '\0');
        glGetProgramInfoLog(name(), GLsizei(log.size()), &length, log.data());
        log.resize(std::size_t(length));
        throw Error(ErrorKind::kBadInput, {files.front(), ""}, "does not link: " + log);
    }
    glObjectLabel(GL_PROGRAM, name(), GLsizei(files.front().size()), files.front().c_str());
    ++glCounters().programsBuilt;
    glCounters().programsMs +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void Program::setInt(GLint location, int value) const {
    glProgramUniform1i(name(), location, value);
}

}  // namespace ribalta
