// The shaders' own mathematics as C++ in single precision: shader_float::f. Includes the copies of
// shaders/lib whose literals the build has made floats. For one test file's own use.
#pragma once

#include <glm/glm.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

namespace ribalta::shader_float {
namespace {

using glm::abs;
using glm::atan;
using glm::clamp;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::exp2;
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::pow;
using glm::sqrt;
using glm::tan;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;

// clang-format off
#define OUT(T) T&
#include "pi.glsl"
#include "phase_function.glsl"
#include "spot_light.glsl"
#include "haze.glsl"
#include "beam_radiance.glsl"
#include "beam_geometry.glsl"
#include "brdf.glsl"
#include "tonemap.glsl"
#include "air.glsl"
#include "air_shell.glsl"
#include "chapman.glsl"
#include "sky_chapman.glsl"
#include "sky_mapping.glsl"
#include "sky_mapping_2008.glsl"
#undef OUT
// clang-format on

}  // namespace
}  // namespace ribalta::shader_float

#pragma GCC diagnostic pop
