// What a texel of each texture format takes.
#pragma once

#include <cstddef>

#include <epoxy/gl.h>

namespace ribalta {

/// Of a sized internal format that the project uses.
std::size_t bytesPerTexel(GLenum format);

}  // namespace ribalta
