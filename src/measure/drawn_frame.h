// What the renderer itself finds of visibility, for references that are to share it.
#pragma once

#include "reference/reference_picture.h"
#include "render/renderer.h"

namespace ribalta {

/// Draws a frame as `reference` asks (camera, size, haze, ambient) with haze that dims surfaces but
/// sends no light to the eye, and reads it and its shadow maps back. Lamps, maps and surfaces are
/// those of a frame with beams. Throws Error(kJobFailed).
DrawnFrame drawForReference(Renderer& renderer, const Scene& scene,
                            const ReferenceSettings& reference);

}  // namespace ribalta
