// Normals for primitives that have none, as glTF 2.0 (section 3.7.2.1) asks: flat.
#pragma once

#include "scene/mesh.h"

namespace ribalta::gltf {

/// Gives every triangle its own three vertices and their common normal. Triangles only; those
/// without area get +Y.
void makeFlatNormals(Primitive& primitive);

}  // namespace ribalta::gltf
