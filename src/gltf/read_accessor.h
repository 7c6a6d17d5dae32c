// The one way to numbers in buffers: every accessor, whatever its type, stride, sparseness and
// normalisation, checked against its buffer and the budget before memory is
// taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "gltf/import.h"

namespace ribalta::gltf {

/// Most elements of an accessor that has no bufferView and so costs the file nothing.
inline constexpr std::size_t kMaxElementsWithoutData = std::size_t(1) << 22U;

/// An accessor's elements as floats; normalised integers become 0..1 or -1..1, others keep their
/// value. Throw Error(kBadInput) where the accessor is of another type or reaches past its data.
std::vector<float> readScalars(const Import& import, std::size_t accessor);
std::vector<glm::vec2> readVec2(const Import& import, std::size_t accessor);
std::vector<glm::vec3> readVec3(const Import& import, std::size_t accessor);
std::vector<glm::vec4> readVec4(const Import& import, std::size_t accessor);

/// MAT4 of floats. Throws Error(kBadInput).
std::vector<glm::mat4> readMat4(const Import& import, std::size_t accessor);

/// VEC4, or VEC3 with 1 as the fourth.
std::vector<glm::vec4> readColors(const Import& import, std::size_t accessor);

/// Unsigned integer scalars as they are. Throws Error(kBadInput).
std::vector<std::uint32_t> readIndices(const Import& import, std::size_t accessor);

}  // namespace ribalta::gltf
