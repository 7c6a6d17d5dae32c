// Scene: all that a file says of a stage, as plain data. No JSON, no graphics API.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "scene/animation.h"
#include "scene/bounds.h"
#include "scene/camera.h"
#include "scene/deformer.h"
#include "scene/dial.h"
#include "scene/environment.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/node.h"
#include "scene/skin.h"

namespace ribalta {

/// Indices between the vectors are checked on import: in range or -1.
struct Scene {
    std::string name;
    double unitMetres = 1.0;  ///< roots are scaled by it
    std::vector<Node> nodes;  ///< parents before children
    std::vector<Mesh> meshes;
    std::vector<Skin> skins;
    std::vector<Deformer> deformers;  ///< one a node whose mesh changes shape
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Image> images;
    std::vector<Camera> cameras;
    std::vector<SpotLight> spotLights;
    std::vector<PointLight> pointLights;
    std::vector<DirectionalLight> directionalLights;
    std::optional<Environment> environment;  ///< none: no light but that of lamps and the settings
    std::vector<Animation> animations;  ///< in the file's order; the scene stands at its rest pose
    std::vector<Mover> movers;          ///< the nodes that they move
    std::vector<Dial> dials;            ///< what else they change
};

/// Computes every node's worldFromLocal, which nodes and lamps are shown, the frames of the cameras
/// and lamps that hang on nodes, and the shapes of what is deformed.
void placeNodes(Scene& scene);

/// A primitive's box in its node's local metres, in the shape that it has there; what is deformed
/// may fill less of it.
Bounds localBounds(const Scene& scene, const Node& node, const Primitive& primitive);

/// The box around all that is drawn, in world metres; empty where nothing is. What is deformed may
/// fill less of it.
Bounds sceneBounds(const Scene& scene);
/// The same around every vertex of what is deformed: for framing a picture, not for every frame.
Bounds tightSceneBounds(const Scene& scene);

}  // namespace ribalta
