// One of a file's named things, as a user asks for it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/error.h"

namespace ribalta::gltf {

/// The place in `names` of that name, else of that number from 0. Throws Error(kUsage) that lists
/// them where there is none; `thing` is what they are called, `none` the cure where there are none.
std::size_t findNamed(const std::vector<std::string>& names, const std::string& nameOrIndex,
                      const char* thing, const char* none, const Place& file);

}  // namespace ribalta::gltf
