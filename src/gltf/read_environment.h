// Image-based lights (EXT_lights_image_based): the light around a scene, from their coefficients of
// irradiance. Their pictures are not read.
#pragma once

#include "base/report.h"
#include "gltf/import.h"
#include "scene/scene.h"

namespace ribalta::gltf {

/// Gives the scene the light that the document's scene `index` names; -1: there is no scene.
/// Reports what is not drawn of it, and a light that cannot be.
void readEnvironment(const Import& import, int index, Scene& scene, Report& report);

}  // namespace ribalta::gltf
