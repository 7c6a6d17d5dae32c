// MaterialTextures: a scene's pictures as its materials read them, in double precision. Bilinear at
// full size where the sampler magnifies linearly, the nearest texel where it does not; no mip
// levels.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "reference/placed_surface.h"
#include "scene/scene.h"

namespace ribalta {

class MaterialTextures {
  public:
    /// Decodes the pictures that materials use. The scene must outlive this.
    explicit MaterialTextures(const Scene& scene);

    /// How a picture's 8-bit R, G and B are meant.
    enum class Meaning { kColors, kData };

    /// R, G, B, A of a slot at a place of a triangle; (0, 0, 0, 1) where the picture is missing.
    glm::dvec4 sample(const TextureSlot& slot, Meaning meaning, const PlacedSurface& surface,
                      std::size_t triangle, const glm::dvec3& weights) const;

    /// The surface's own alpha at a place: material, vertices and texture.
    double alpha(const PlacedSurface& surface, std::size_t triangle,
                 const glm::dvec3& weights) const;
    /// Whether a masked surface is there at that place; any other is.
    bool isThere(const PlacedSurface& surface, std::size_t triangle,
                 const glm::dvec3& weights) const {
        return !surface.isMasked() ||
               alpha(surface, triangle, weights) >= double(surface.material->alphaCutoff);
    }
    /// Texels of the slot's picture, 0 where it is missing.
    glm::dvec2 size(const TextureSlot& slot) const;

    /// Texture coordinates of a slot at a place of a triangle.
    static glm::dvec2 coordinates(const TextureSlot& slot, const PlacedSurface& surface,
                                  std::size_t triangle, const glm::dvec3& weights);

  private:
    /// Linear R, G, B, A.
    struct Texels {
        int width = 0;
        int height = 0;
        std::vector<glm::vec4> values;
    };
    const Texels* find(const TextureSlot& slot, Meaning meaning) const;
    void decode(const std::optional<TextureSlot>& slot, Meaning meaning);

    const Scene& scene_;
    std::vector<std::array<std::optional<Texels>, 2>> images_;  ///< by image and meaning
};

}  // namespace ribalta
