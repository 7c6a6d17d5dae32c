// Lets a struct be read by GLSL and by C++ alike.
#pragma once
#ifndef GLSL
#include <glm/glm.hpp>
namespace ribalta::gpu {
using vec2 = glm::vec2;
using vec4 = glm::vec4;
using ivec4 = glm::ivec4;
using mat4 = glm::mat4;
using uint = unsigned int;
}  // namespace ribalta::gpu
#define SHARED_BEGIN namespace ribalta::gpu {
#define SHARED_END }
#else
#define SHARED_BEGIN
#define SHARED_END
#endif
