// Materials and the textures they use.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "base/report.h"
#include "gltf/import.h"
#include "gltf/read_images.h"
#include "scene/material.h"

namespace ribalta::gltf {

/// Collects the textures that drawn materials use, each once.
class TextureTable {
  public:
    TextureTable(const Import& import, ImageTable& images) : import_(import), images_(images) {}

    /// Index into textures() of a texture of the glTF, or -1 where it has no image.
    int use(std::size_t texture);
    /// Index into the scene's images of a glTF texture's image, or -1 where it has none.
    int useImageOf(std::size_t texture);

    /// Why a texture has no index.
    std::string faultOf(std::size_t texture) const;

    const std::vector<Texture>& textures() const { return textures_; }

  private:
    const Import& import_;
    ImageTable& images_;
    std::vector<Texture> textures_;
    std::map<std::size_t, int> known_;
};

/// The glTF's material `index`, its textures entered into the table.
Material readMaterial(const Import& import, std::size_t index, TextureTable& textures,
                      Report& report);

/// Which texture coordinates (0 or 1) the tangents of the glTF's material `index` follow: its
/// normal map's, else those of its anisotropy or its coat; -1 where it needs no tangents.
int tangentUvOf(const Import& import, std::size_t index);

}  // namespace ribalta::gltf
