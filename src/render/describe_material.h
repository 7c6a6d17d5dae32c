// What shaders are told of a material: its numbers, and how its pictures are looked up.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include <shared/surface.h>

#include "scene/material.h"

namespace ribalta {

/// One of a material's texture slots, and whether its pictures hold colours.
struct SlotUse {
    const std::optional<TextureSlot>* slot;
    bool colors;
};

/// In the order of shared/surface.h.
std::array<SlotUse, gpu::kMaterialTextures> slotsOf(const Material& material);
std::array<SlotUse, gpu::kLayerTextures> slotsOf(const MaterialLayers& layers);

/// Whether the picture of a slot that is used is on the GPU.
using IsUploaded = std::function<bool(const TextureSlot& slot, bool colors)>;

gpu::SurfaceMaterial describeMaterial(const Material& material, const IsUploaded& isUploaded);
gpu::SurfaceLayers describeLayers(const MaterialLayers& layers, const IsUploaded& isUploaded);

}  // namespace ribalta
