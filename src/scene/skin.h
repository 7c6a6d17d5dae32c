// Skin: the joints that a mesh hangs on.
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace ribalta {

/// At least one joint. A mesh's vertices name them by their index here.
struct Skin {
    std::string name;
    std::vector<int> joints;                ///< into Scene::nodes
    std::vector<glm::dmat4> jointFromMesh;  ///< one a joint: where the mesh was bound to it
};

}  // namespace ribalta
