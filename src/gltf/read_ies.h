// EXT_lights_ies: lamps whose light was measured, as spots with light maps.
#pragma once

#include <cstddef>
#include <map>
#include <optional>

#include "base/report.h"
#include "gltf/import.h"
#include "gltf/project_web.h"
#include "gltf/read_images.h"
#include "scene/scene.h"

namespace ribalta::gltf {

/// The file's light profiles, each read and projected once, when a lamp first uses it.
class IesLamps {
  public:
    explicit IesLamps(const Import& import) : import_(import) {}

    /// Adds the spot of a node that has the extension. Returns whether it has one that can be
    /// drawn; then a light of KHR_lights_punctual on the same node is its stand-in for programs
    /// that do not know the extension, and is left out. What cannot be used is reported.
    bool add(std::size_t gltfNode, int sceneNode, ImageTable& images, Scene& scene, Report& report);

  private:
    /// A profile that is in use.
    struct Profile {
        double halfAngle = 0.0;
        double candela = 0.0;
        int image = -1;
    };

    const std::optional<Profile>& profile(std::size_t index, ImageTable& images, Report& report);

    const Import& import_;
    std::map<std::size_t, std::optional<Profile>> profiles_;  ///< none: it cannot be used
};

}  // namespace ribalta::gltf
