// DrawList: the scene's primitives, one entry for each place they stand in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace ribalta {

struct DrawItem {
    int node = 0;           ///< into Scene::nodes
    int mesh = 0;           ///< into Scene::meshes
    int primitive = 0;      ///< into that mesh's primitives
    int material = -1;      ///< into Scene::materials, -1: the default
    bool mirrored = false;  ///< triangles face the other way than in their mesh
    Bounds worldBounds;
};

/// Where an item stands and what shape it has: equal where it would be drawn alike.
struct DrawPlace {
    int node = 0;  ///< into Scene::nodes: the list's own numbers change with what is shown
    int primitive = 0;
    glm::dmat4 worldFromLocal{1.0};
    std::uint64_t shape = 0;  ///< of its deformer, 0: of its own
    float alpha = 1.0F;       ///< of its material, where that decides what of it is there

    bool operator==(const DrawPlace&) const = default;
};
DrawPlace placeOf(const Scene& scene, const std::vector<DrawItem>& draws, int draw);

/// The node's deformer, by which the item's shape changes; -1: it has its own.
int deformerOf(const Scene& scene, const DrawItem& item);

/// All primitives of all nodes, in the nodes' order.
std::vector<DrawItem> listDraws(const Scene& scene);

/// Whether one call draws both, the same geometry at two places.
bool areInstances(const Scene& scene, const DrawItem& a, const DrawItem& b);

/// Brings instances together in a list of draws, at the place of the first of each kind; otherwise
/// and among themselves they stay in order.
void gatherInstances(const Scene& scene, const std::vector<DrawItem>& draws,
                     std::vector<int>& list);

/// Where the run of instances ends that begins at `first` in a list of draws.
std::size_t endOfInstances(const Scene& scene, const std::vector<DrawItem>& draws,
                           const std::vector<int>& list, std::size_t first);

/// The item's primitive.
const Primitive& primitiveOf(const Scene& scene, const DrawItem& item);

/// The item's material, glTF's default where it names none.
const Material& materialOf(const Scene& scene, const DrawItem& item);

/// Points, lines and what is blended cast none.
bool castsShadow(const Scene& scene, const DrawItem& item);

}  // namespace ribalta
