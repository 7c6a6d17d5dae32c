// Node: one place in the scene's hierarchy.
#pragma once

#include <string>

#include <glm/glm.hpp>

namespace ribalta {

/// Indices are into the Scene's own vectors; -1 is none.
struct Node {
    std::string name;
    int parent = -1;  ///< stands before its children in Scene::nodes
    glm::dmat4 parentFromLocal{1.0};
    glm::dmat4 worldFromLocal{1.0};  ///< product up to the root; see placeNodes
    int mesh = -1;
    bool visible = true;  ///< its own; see shown
    bool shown = true;    ///< it and all above it are visible; see placeNodes
    int deformer = -1;    ///< into Scene::deformers: the mesh's shape changes

    bool isDrawn() const { return mesh >= 0 && shown; }
};

/// Whether less than a plane is left of a mesh that the matrix places: nothing of it is drawn.
bool vanishes(const glm::dmat4& worldFromLocal);

}  // namespace ribalta
