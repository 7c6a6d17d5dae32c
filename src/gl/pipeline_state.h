// PipelineState: all the fixed-function state of a draw. A draw names a complete one; nothing is
// inherited from the draw before.
#pragma once

#include "gl/handle.h"

namespace ribalta {

class Program;

enum class DepthTest {
    kOff,
    kCloser,  ///< passes nearer than what is there (reversed depth: greater)
    kCloserOrEqual,
};

enum class Blend {
    kReplace,
    kAdd,    ///< source + destination
    kAlpha,  ///< source * a + destination * (1 - a)
    kTint,   ///< source * destination; alphas as kAlpha's
};

struct PipelineState {
    const Program* program = nullptr;
    GLuint vertexArray = 0;
    DepthTest depthTest = DepthTest::kOff;
    bool depthWrite = false;
    Blend blend = Blend::kReplace;
    bool cullBackFaces = false;
    bool clockwiseFront = false;  ///< for mirrored geometry
};

void apply(const PipelineState& state);

}  // namespace ribalta
