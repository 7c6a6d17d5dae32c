// Dials of a scene: what animation pointers name, found in the scene once all of it is read.
#pragma once

#include <cstddef>
#include <vector>

#include "base/report.h"
#include "gltf/animation_pointer.h"
#include "gltf/import.h"
#include "scene/scene.h"

namespace ribalta::gltf {

/// A thing of the document some numbers of which are animated.
struct DialSource {
    PointedAt::Owner owner = PointedAt::Owner::kNode;
    std::size_t index = 0;  ///< of the scene's node, else into the document's list
    Dial::Numbers numbers = Dial::Numbers::kVisible;
    Place place;  ///< of the first pointer to it
};

/// Where the scene has the document's own things.
struct SceneUses {
    std::vector<std::size_t> gltfNodes;  ///< by the scene's node: the document's
    std::vector<char> isPunctual;        ///< by the scene's node: its lamp is KHR_lights_punctual's
    std::vector<int> materials;          ///< by the document's material: the scene's; -1: unused
};

/// Makes the scene's dials. Channels of Part::kDial count into `sources` before, and into
/// Scene::dials after; those of what the scene does not have are left out, which is reported. The
/// scene is as the file has it, its units not scaled yet.
void bindDials(const Import& import, const std::vector<DialSource>& sources, const SceneUses& uses,
               Scene& scene, Report& report);

}  // namespace ribalta::gltf
