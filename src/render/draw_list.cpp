#include "render/draw_list.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ribalta {

std::vector<DrawItem> listDraws(const Scene& scene) {
    std::vector<DrawItem> items;
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        const Node& node = scene.nodes[n];
        if (!node.isDrawn()) {
            continue;
        }
        const Mesh& mesh = scene.meshes[std::size_t(node.mesh)];
        const bool mirrored = glm::determinant(glm::dmat3(node.worldFromLocal)) < 0.0;
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
            const Primitive& primitive = mesh.primitives[p];
            if (!primitive.indices.empty()) {
                items.push_back(
                    {int(n), node.mesh, int(p), primitive.material, mirrored,
                     transformed(node.worldFromLocal, localBounds(scene, node, primitive))});
            }
        }
    }
    return items;
}

bool areInstances(const Scene& scene, const DrawItem& a, const DrawItem& b) {
    return a.mesh == b.mesh && a.primitive == b.primitive && a.material == b.material &&
           a.mirrored == b.mirrored && deformerOf(scene, a) < 0 && deformerOf(scene, b) < 0;
}

void gatherInstances(const Scene& scene, const std::vector<DrawItem>& draws,
                     std::vector<int>& list) {
    // Materials are their primitives', so that geometry and side tell the kinds apart.
    std::vector<std::size_t> firstKind(scene.meshes.size() + 1, 0);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        firstKind[m + 1] = firstKind[m] + 2 * scene.meshes[m].primitives.size();
    }
    constexpr std::size_t kUnseen = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> rankOfKind(firstKind.back(), kUnseen);
    std::vector<std::pair<std::size_t, int>> ranked;
    ranked.reserve(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        const DrawItem& item = draws[std::size_t(list[i])];
        std::size_t rank = i;
        if (deformerOf(scene, item) < 0) {
            std::size_t& known =
                rankOfKind[firstKind[std::size_t(item.mesh)] + 2 * std::size_t(item.primitive) +
                           (item.mirrored ? 1 : 0)];
            known = known == kUnseen ? i : known;
            rank = known;
        }
        ranked.emplace_back(rank, list[i]);
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i] = ranked[i].second;
    }
}

std::size_t endOfInstances(const Scene& scene, const std::vector<DrawItem>& draws,
                           const std::vector<int>& list, std::size_t first) {
    std::size_t end = first + 1;
    while (end < list.size() &&
           areInstances(scene, draws[std::size_t(list[first])], draws[std::size_t(list[end])])) {
        ++end;
    }
    return end;
}

DrawPlace placeOf(const Scene& scene, const std::vector<DrawItem>& draws, int draw) {
    const DrawItem& item = draws[std::size_t(draw)];
    const int deformer = deformerOf(scene, item);
    const Material& material = materialOf(scene, item);
    const bool isMasked = material.alphaMode == Material::AlphaMode::kMask;
    return {item.node, item.primitive, scene.nodes[std::size_t(item.node)].worldFromLocal,
            deformer < 0 ? 0 : scene.deformers[std::size_t(deformer)].shape,
            isMasked ? material.baseColor.w : 1.0F};
}

int deformerOf(const Scene& scene, const DrawItem& item) {
    return scene.nodes[std::size_t(item.node)].deformer;
}

const Primitive& primitiveOf(const Scene& scene, const DrawItem& item) {
    return scene.meshes[std::size_t(item.mesh)].primitives[std::size_t(item.primitive)];
}

const Material& materialOf(const Scene& scene, const DrawItem& item) {
    static const Material defaultMaterial;
    return item.material < 0 ? defaultMaterial : scene.materials[std::size_t(item.material)];
}

bool castsShadow(const Scene& scene, const DrawItem& item) {
    return primitiveOf(scene, item).topology == Topology::kTriangles &&
           !materialOf(scene, item).isSeeThrough();
}

}  // namespace ribalta
