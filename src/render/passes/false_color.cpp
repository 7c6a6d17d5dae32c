#include "render/passes/false_color.h"

#include <shared/slots.h>

#include "gl/counters.h"
#include "gl/pipeline_state.h"

namespace ribalta {

FalseColorPass::FalseColorPass()
    : program_({"passes/full_screen.vert", "passes/false_color.frag"}) {
    GLuint array = 0;
    glCreateVertexArrays(1, &array);
    vertexArray_ = Handle<deleteVertexArray>(array);
}

void FalseColorPass::draw(double highestLux, const FrameTargets& targets) {
    targets.screen.bind();
    PipelineState state;
    state.program = &program_;
    state.vertexArray = vertexArray_.name();
    apply(state);
    glProgramUniform1f(program_.name(), 0, float(highestLux));
    glBindTextureUnit(gpu::kColorUnit, targets.color.name());
    glBindTextureUnit(gpu::kDepthUnit, targets.depth.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ++glCounters().drawCalls;
}

}  // namespace ribalta
