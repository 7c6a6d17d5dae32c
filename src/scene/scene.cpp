#include "scene/scene.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace ribalta {
namespace {

// The sum of boundsOfOne(node, primitive) over all that is placed.
template <typename BoundsOfOne>
Bounds boundsOf(const Scene& scene, const BoundsOfOne& boundsOfOne) {
    Bounds bounds;
    for (const Node& node : scene.nodes) {
        if (!node.isDrawn()) {
            continue;
        }
        for (const Primitive& primitive : scene.meshes[std::size_t(node.mesh)].primitives) {
            bounds.add(boundsOfOne(node, primitive));
        }
    }
    return bounds;
}

}  // namespace

Frame rigidFrame(const glm::dmat4& worldFromLocal) {
    Frame frame;
    frame.position = glm::dvec3(worldFromLocal[3]);
    // Gram-Schmidt from the viewing axis: a sheared or mirrored node still aims where its -Z goes.
    const glm::dvec3 back(worldFromLocal[2]);
    const glm::dvec3 up(worldFromLocal[1]);
    const glm::dvec3 right = glm::cross(up, back);
    const double size = glm::length(up) * glm::length(back);
    if (!(size > 0.0) || !(glm::length(right) > 1e-9 * size) || !std::isfinite(size)) {
        return frame;
    }
    const glm::dvec3 z = glm::normalize(back);
    const glm::dvec3 x = glm::normalize(right);
    frame.worldFromLocal = glm::dmat3(x, glm::cross(z, x), z);
    return frame;
}

Frame lookAt(const glm::dvec3& position, const glm::dvec3& target, const glm::dvec3& up) {
    if (position == target) {
        return {position, glm::dmat3(1.0)};
    }
    const glm::dvec3 z = glm::normalize(position - target);
    const bool parallel = glm::length(glm::cross(up, z)) <= 1e-6 * glm::length(up);
    const glm::dvec3 other = std::abs(z.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0)
                                                 : glm::dvec3(0.0, 0.0, z.y > 0.0 ? -1.0 : 1.0);
    const glm::dvec3 hint = parallel ? other : up;
    const glm::dvec3 x = glm::normalize(glm::cross(hint, z));
    return {position, glm::dmat3(x, glm::cross(z, x), z)};
}

bool vanishes(const glm::dmat4& worldFromLocal) {
    // Where all three cross products are nothing.
    const glm::dmat3 axes(worldFromLocal);
    return glm::cross(axes[0], axes[1]) == glm::dvec3(0.0) &&
           glm::cross(axes[1], axes[2]) == glm::dvec3(0.0) &&
           glm::cross(axes[2], axes[0]) == glm::dvec3(0.0);
}

void placeNodes(Scene& scene) {
    for (Node& node : scene.nodes) {
        node.worldFromLocal = node.parentFromLocal;
        if (node.parent < 0 && scene.unitMetres != 1.0) {
            node.worldFromLocal =
                glm::scale(glm::dmat4(1.0), glm::dvec3(scene.unitMetres)) * node.parentFromLocal;
        }
        node.shown = node.visible;
        if (node.parent >= 0) {
            const Node& parent = scene.nodes[std::size_t(node.parent)];
            node.worldFromLocal = parent.worldFromLocal * node.parentFromLocal;
            node.shown = node.visible && parent.shown;
        }
    }
    const auto frameOf = [&](int node) {
        return rigidFrame(scene.nodes[std::size_t(node)].worldFromLocal);
    };
    for (Camera& camera : scene.cameras) {
        if (camera.node >= 0) {
            camera.frame = frameOf(camera.node);
        }
    }
    for (SpotLight& lamp : scene.spotLights) {
        if (lamp.node >= 0) {
            lamp.frame = frameOf(lamp.node);
            lamp.shown = scene.nodes[std::size_t(lamp.node)].shown;
        }
    }
    for (PointLight& lamp : scene.pointLights) {
        if (lamp.node >= 0) {
            lamp.position = frameOf(lamp.node).position;
            lamp.shown = scene.nodes[std::size_t(lamp.node)].shown;
        }
    }
    for (DirectionalLight& lamp : scene.directionalLights) {
        if (lamp.node >= 0) {
            lamp.direction = frameOf(lamp.node).forward();
            lamp.shown = scene.nodes[std::size_t(lamp.node)].shown;
        }
    }
    shapeDeformers(scene);
}

Bounds localBounds(const Scene& scene, const Node& node, const Primitive& primitive) {
    return node.deformer < 0
               ? primitive.bounds
               : deformedBounds(primitive, scene.deformers[std::size_t(node.deformer)]);
}

Bounds sceneBounds(const Scene& scene) {
    return boundsOf(scene, [&](const Node& node, const Primitive& primitive) {
        return transformed(node.worldFromLocal, localBounds(scene, node, primitive));
    });
}

Bounds tightSceneBounds(const Scene& scene) {
    return boundsOf(scene, [&](const Node& node, const Primitive& primitive) {
        if (node.deformer < 0) {
            return transformed(node.worldFromLocal, primitive.bounds);
        }
        Bounds bounds;
        const Deformer& deformer = scene.deformers[std::size_t(node.deformer)];
        for (const glm::vec3& position : deformVertices(primitive, deformer).positions) {
            bounds.add(glm::dvec3(node.worldFromLocal * glm::dvec4(glm::dvec3(position), 1.0)));
        }
        return bounds;
    });
}

}  // namespace ribalta
