// The units of a file that are not glTF's: scaled where its user says so, guessed at for a hint.
#pragma once

#include "base/report.h"
#include "gltf/load_options.h"
#include "scene/scene.h"

namespace ribalta::gltf {

/// Lengths and lamps as the options say; nodes follow when they are placed.
void scaleUnits(const LoadOptions& options, Scene& scene);

/// Says where a placed scene looks as if it were in centimetres, or its lamps without physical
/// units, unless the options have said so already.
void hintAtUnits(const LoadOptions& options, const Place& file, const Scene& scene, Report& report);

}  // namespace ribalta::gltf
