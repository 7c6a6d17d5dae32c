// How many work groups a compute shader is started with.
#pragma once

#include <epoxy/gl.h>

namespace ribalta {

/// Groups of `side` invocations that cover `count`, of which the last may be partly idle.
inline GLuint workGroups(int count, int side) {
    return GLuint((count + side - 1) / side);
}

}  // namespace ribalta
