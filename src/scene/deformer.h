// Deformer: a mesh of changing shape at one place of the scene, and the shape that it has. Skinned
// by joints, morphed by weighted targets, or both: morphed, then skinned (glTF 2.0, section 3.7).
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/bounds.h"
#include "scene/mesh.h"

namespace ribalta {

struct Scene;

struct Deformer {
    int node = -1;  ///< into Scene::nodes; one of its own where the deformer has a skin
    int skin = -1;  ///< into Scene::skins, -1: nothing but morph targets
    /// As the file has them, by morph target; empty where there are none.
    std::vector<float> restWeights;

    std::vector<float> weights;            ///< as posed, by morph target
    std::vector<glm::mat4> localFromMesh;  ///< as posed, by joint; empty without a skin
    /// Equal where weights and matrices are, else another: tells shapes apart. Never 0.
    std::uint64_t shape = 1;
};

/// Brings all deformers to where their joints stand. Joints place a skinned mesh in the world,
/// wherever the file has it: its node is put where the first joint is, upright, and mirrored where
/// most joints are, so that front faces are told from back faces. For placeNodes. Takes no memory
/// after the first time.
void shapeDeformers(Scene& scene);

/// A primitive's arrays in a deformer's shape; in its node's local metres. `normals` and `tangents`
/// are of unit length, and empty where the primitive has none.
struct DeformedVertices {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;
};
DeformedVertices deformVertices(const Primitive& primitive, const Deformer& deformer);

/// A box that holds the primitive in the deformer's shape, found without looking at its vertices:
/// of what hangs on each joint, and of how far each target goes. Local metres.
Bounds deformedBounds(const Primitive& primitive, const Deformer& deformer);

}  // namespace ribalta
