// What is wrong with a Scene that an import made: every promise of the headers in src/scene.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace ribalta::test {

/// One line for each broken promise (an index out of range, a number that is not finite, an array
/// of the wrong length); empty where the scene is as its headers say.
std::vector<std::string> sceneFaults(const Scene& scene);

}  // namespace ribalta::test
