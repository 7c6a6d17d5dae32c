// Hashes that tell whether a measurement is of the same scene, drawn by the same program.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "scene/scene.h"

namespace ribalta {

/// Of a scene as it was loaded: the file's own bytes, and the geometry and images that may lie in
/// other files. 16 hexadecimal digits.
std::string hashScene(std::span<const std::byte> file, const Scene& scene);

/// Of this very program: its version may stay while its shaders and methods change.
std::string hashProgram();

}  // namespace ribalta
