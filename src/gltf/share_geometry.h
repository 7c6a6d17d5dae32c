// Equal geometry found, so that it is uploaded once: exporters write a mesh anew for each material
// it is drawn with, and all vertices for each part of a mesh.
#pragma once

#include <vector>

#include "scene/mesh.h"

namespace ribalta::gltf {

/// Numbers the primitives' sharedVertices and sharedIndices. Byte by byte equal counts, wherever in
/// the file it comes from; what has morph targets keeps vertices of its own.
void shareGeometry(std::vector<Mesh>& meshes);

}  // namespace ribalta::gltf
