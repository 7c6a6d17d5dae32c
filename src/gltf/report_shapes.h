// What breaks a rule of glTF 2.0 about skins and morph targets, or is odd, whether it is drawn or
// not.
#pragma once

#include "base/report.h"
#include "gltf/import.h"

namespace ribalta::gltf {

/// Reports joints without a common root, a skeleton that is none, joints listed twice, too few or
/// unfit inverse bind matrices, primitives of one mesh with different numbers of morph targets, and
/// targets whose length is not their primitive's.
void reportShapes(const Import& import, Report& report);

}  // namespace ribalta::gltf
