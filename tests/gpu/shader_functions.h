// The functions of shaders/lib that src/optics has no use for, in double precision; see
// optics/shader_lib.h for how. For one test file's own use.
#pragma once

#include "optics/shader_lib.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wkeyword-macro"
#endif

namespace ribalta::shader {
namespace {

using vec4 = glm::dvec4;

// NOLINTBEGIN: GLSL's spelling
#define float double
#include "lib/view_ray.glsl"
#undef float
// NOLINTEND

}  // namespace
}  // namespace ribalta::shader

#ifdef __clang__
#pragma clang diagnostic pop
#endif
#pragma GCC diagnostic pop
