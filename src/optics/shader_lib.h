// The shaders' own mathematics (shaders/lib/*.glsl) as C++ in double precision: ribalta::shader::f
// is the f of the .glsl. Nothing is written here; units and ranges stand there.
//
// The functions sit in an unnamed namespace, one private copy a translation unit: include this
// header from .cpp files only, never from another header.
#pragma once

#include <glm/glm.hpp>

#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wkeyword-macro"
#endif
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

namespace ribalta::shader {
namespace {

using glm::abs;
using glm::asin;
using glm::atan;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::exp2;
using glm::length;
using glm::log;
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::pow;
using glm::sqrt;
using glm::tan;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
using mat4 = glm::dmat4;

// NOLINTBEGIN: GLSL's spelling
#define float double
#define OUT(T) T&
// beam_radiance.glsl needs haze.glsl and spot_light.glsl before it, air_shell.glsl air.glsl,
// brdf.glsl pi.glsl, layers.glsl both, the sky's files what they say.
// clang-format off
#include "lib/pi.glsl"
#include "lib/phase_function.glsl"
#include "lib/spot_light.glsl"
#include "lib/haze.glsl"
#include "lib/haze_cloud.glsl"
#include "lib/beam_radiance.glsl"
#include "lib/beam_geometry.glsl"
#include "lib/brdf.glsl"
#include "lib/environment.glsl"
#include "lib/layers.glsl"
#include "lib/shadow_projection.glsl"
#include "lib/tonemap.glsl"
#include "lib/auto_exposure.glsl"
#include "lib/false_color.glsl"
#include "lib/air.glsl"
#include "lib/air_shell.glsl"
#include "lib/chapman.glsl"
#include "lib/sky_chapman.glsl"
#include "lib/sky_mapping.glsl"
#include "lib/sky_mapping_2008.glsl"
#include "lib/sky_tables.glsl"
#include "lib/sun_disc.glsl"
#include "lib/deform.glsl"
// clang-format on
#undef OUT
#undef float
// NOLINTEND

}  // namespace
}  // namespace ribalta::shader

#pragma GCC diagnostic pop
#ifdef __clang__
#pragma clang diagnostic pop
#endif
