// Scene: all that a file says of a stage, as plain data. No JSON, no graphics API.
#pragma once

#include <string>
#include <vector>

#include "image/image.h"
#include "scene/animation.h"
#include "scene/bounds.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/node.h"

namespace ribalta {

/// Indices between the vectors are checked on import: in range or -1.
struct Scene {
    std::string name;
    std::vector<Node> nodes;  ///< parents before children
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Image> images;
    std::vector<Camera> cameras;
    std::vector<SpotLight> spotLights;
    std::vector<PointLight> pointLights;
    std::vector<DirectionalLight> directionalLights;
    std::vector<Animation> animations;  ///< in the file's order; the scene stands at its rest pose
    std::vector<Mover> movers;          ///< the nodes that they move
};

/// Computes every node's worldFromLocal, which nodes and lamps are shown, and the frames of the
/// cameras and lamps that hang on nodes.
void placeNodes(Scene& scene);

/// The box around all that is drawn, in world metres; empty where nothing is.
Bounds sceneBounds(const Scene& scene);

}  // namespace ribalta
