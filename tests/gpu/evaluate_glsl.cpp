// A compute shader put together from the embedded library and a few statements.
#include "evaluate_glsl.h"

#include <gtest/gtest.h>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/shader_library.h"

namespace ribalta::test {
namespace {

Handle<deleteProgram> compile(const std::string& body, int inputs, int outputs) {
    // The library's files include nothing; the first brings the version line and the macros.
    std::string text = assembleShader("lib/haze.glsl", {}).text;
    for (const char* file :
         {"pi", "phase_function", "spot_light", "beam_radiance", "beam_geometry", "brdf", "tonemap",
          "shadow_projection", "view_ray", "air", "air_shell", "chapman"}) {
        text += embeddedShaders().at(std::string("lib/") + file + ".glsl");
    }
    text +=
        "layout(local_size_x = 64) in;\n"
        "layout(std430, binding = 0) readonly buffer In { float inputs[]; };\n"
        "layout(std430, binding = 1) writeonly buffer Out { float outputs[]; };\n"
        "int self;\n"
        "float a(int i) { return inputs[self * " +
        std::to_string(inputs) +
        " + i]; }\n"
        "void put(int i, float x) { outputs[self * " +
        std::to_string(outputs) +
        " + i] = x; }\n"
        "void put3(vec3 v) { put(0, v.x); put(1, v.y); put(2, v.z); }\n"
        "vec3 a3(int i) { return vec3(a(i), a(i + 1), a(i + 2)); }\n"
        "void main() {\n"
        "    self = int(gl_GlobalInvocationID.x);\n"
        "    if (self * " +
        std::to_string(inputs) + " >= inputs.length()) { return; }\n" + body + "\n}\n";
    const char* source = text.c_str();
    Handle<deleteProgram> program(glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source));
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) {
        std::string log(4096, '\0');
        glGetProgramInfoLog(program.name(), GLsizei(log.size()), nullptr, log.data());
        ADD_FAILURE() << body << "\n" << log.c_str();
    }
    return program;
}

}  // namespace

std::vector<float> evaluateGlsl(const std::string& body, const std::vector<float>& values,
                                int inputs, int outputs) {
    const std::size_t count = values.size() / std::size_t(inputs);
    std::vector<float> results(count * std::size_t(outputs));
    const Handle<deleteProgram> program = compile(body, inputs, outputs);
    Buffer in("inputs", bytesOf(values));
    Buffer out("outputs", bytesOf(results));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out.name());
    glUseProgram(program.name());
    glDispatchCompute(GLuint((count + 63) / 64), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    out.read(std::as_writable_bytes(std::span(results)));
    glUseProgram(0);
    return results;
}

}  // namespace ribalta::test
