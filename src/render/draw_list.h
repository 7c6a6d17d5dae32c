// DrawList: the scene's primitives, one entry for each place they stand in.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace ribalta {

struct DrawItem {
    int node = 0;       ///< into Scene::nodes
    int mesh = 0;       ///< into Scene::meshes
    int primitive = 0;  ///< into that mesh's primitives
    int material = -1;  ///< into Scene::materials, -1: the default
    Bounds worldBounds;
};

/// All primitives of all nodes, in the nodes' order.
std::vector<DrawItem> listDraws(const Scene& scene);

/// The item's primitive.
const Primitive& primitiveOf(const Scene& scene, const DrawItem& item);

/// The item's material, glTF's default where it names none.
const Material& materialOf(const Scene& scene, const DrawItem& item);

/// Points, lines and what is blended cast none.
bool castsShadow(const Scene& scene, const DrawItem& item);

}  // namespace ribalta
