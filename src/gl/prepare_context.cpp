#include "gl/prepare_context.h"

#include <epoxy/gl.h>

#include "gl/debug_output.h"

namespace ribalta {

void prepareContext() {
    installDebugOutput();
    // The same depth on both sides of the projection: 0..1, so that reversed depth keeps its bits.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

}  // namespace ribalta
