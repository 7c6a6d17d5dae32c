#include "render/draw_list.h"

namespace ribalta {

std::vector<DrawItem> listDraws(const Scene& scene) {
    std::vector<DrawItem> items;
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        const Node& node = scene.nodes[n];
        if (!node.isDrawn()) {
            continue;
        }
        const Mesh& mesh = scene.meshes[std::size_t(node.mesh)];
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
            const Primitive& primitive = mesh.primitives[p];
            if (!primitive.indices.empty()) {
                items.push_back(
                    {int(n), node.mesh, int(p), primitive.material,
                     transformed(node.worldFromLocal, localBounds(scene, node, primitive))});
            }
        }
    }
    return items;
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
