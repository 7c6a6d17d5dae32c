#include "gl/pipeline_state.h"

#include "base/check.h"
#include "gl/program.h"

namespace ribalta {
namespace {

void enable(GLenum capability, bool on) {
    if (on) {
        glEnable(capability);
    } else {
        glDisable(capability);
    }
}

}  // namespace

void apply(const PipelineState& state) {
    CHECK(state.program != nullptr && state.vertexArray != 0);
    glUseProgram(state.program->name());
    glBindVertexArray(state.vertexArray);
    enable(GL_DEPTH_TEST, state.depthTest != DepthTest::kOff || state.depthWrite);
    glDepthFunc(state.depthTest == DepthTest::kOff      ? GL_ALWAYS
                : state.depthTest == DepthTest::kCloser ? GL_GREATER
                                                        : GL_GEQUAL);
    glDepthMask(state.depthWrite ? GL_TRUE : GL_FALSE);
    enable(GL_BLEND, state.blend != Blend::kReplace);
    if (state.blend == Blend::kAdd) {
        glBlendFunc(GL_ONE, GL_ONE);
    } else if (state.blend == Blend::kAlpha) {
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    } else if (state.blend == Blend::kTint) {
        glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    }
    enable(GL_CULL_FACE, state.cullBackFaces);
    glFrontFace(state.clockwiseFront ? GL_CW : GL_CCW);
}

}  // namespace ribalta
