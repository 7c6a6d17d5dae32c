#include "render/passes/tonemap.h"

#include <shared/slots.h>

#include "gl/counters.h"
#include "gl/pipeline_state.h"

namespace ribalta {

TonemapPass::TonemapPass() : program_({"passes/full_screen.vert", "passes/tonemap.frag"}) {
    GLuint array = 0;
    glCreateVertexArrays(1, &array);
    vertexArray_ = Handle<deleteVertexArray>(array);
}

void TonemapPass::draw(const FrameTargets& targets) {
    targets.screen.bind();
    PipelineState state;
    state.program = &program_;
    state.vertexArray = vertexArray_.name();
    apply(state);
    glBindTextureUnit(gpu::kColorUnit, targets.color.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ++glCounters().drawCalls;
}

}  // namespace ribalta
