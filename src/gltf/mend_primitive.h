// From what a file may hold to what Primitive promises: equal lengths, finite numbers, unit
// vectors, nothing that is not drawn.
#pragma once

#include "base/error.h"
#include "base/report.h"
#include "scene/mesh.h"

namespace ribalta::gltf {

/// Expects indices in range and unrolled for the primitive's topology. Afterwards it is as
/// scene/mesh.h says, except that triangles may lack normals, tangents and bounds; it may also have
/// no indices left. What was changed is reported at the primitive's `place`.
void mendPrimitive(Primitive& primitive, const Place& place, Report& report);

}  // namespace ribalta::gltf
