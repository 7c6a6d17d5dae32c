// The reference picture: beams and surface light of a whole frame in double precision, the slow,
// exact answer that drawn frames are measured against. Knows neither OpenGL nor files.
//
// A ray goes through the centre of each pixel: no anti-aliasing, as in a drawn frame. Light maps
// are filtered over the width of what the pixel sees, in the haze and on surfaces; textures are
// read bilinearly at full size, without mip levels.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "base/progress.h"
#include "reference/sky_sight.h"
#include "scene/camera.h"
#include "scene/haze.h"
#include "scene/scene.h"

namespace ribalta {

/// One lamp's shadow map as the renderer drew it.
struct DrawnShadowMap {
    int side = 0;             ///< texels
    double inverseTan = 1.0;  ///< 1 / tan of the map's half angle
    double nearMetres = 0.0;
    std::vector<float> depths;  ///< side * side, reversed (near / z), rows along the lamp's up
};

/// What the renderer itself found of visibility in a frame, as plain data.
struct DrawnFrame {
    std::vector<std::optional<DrawnShadowMap>> shadowMaps;  ///< by spot; none: nothing casts there
    std::vector<glm::vec3>
        surfaces;               ///< cd/m2 without beams, dimmed by the haze; rows from the top
    std::vector<float> depths;  ///< metres along the view axis, infinity where nothing is hit
};

struct ReferenceSettings {
    Camera camera;
    int width = 1280;  ///< pixels
    int height = 720;
    Haze haze;
    double ambientLux = 1.0;
    double relativeError = 1e-5;  ///< asked of each pixel's beams; what was reached is told
    /// Null: visibility is that of the scene's own triangles, by ray casting. Otherwise of the
    /// renderer's shadow maps, each texel a hard edge, and surfaces and depths are the frame's:
    /// what is then different from the frame is its integration of beams alone. Must be of this
    /// size.
    const DrawnFrame* drawn = nullptr;
    /// The sky behind and before everything, and daylight; none: black. Needs clear air (no haze)
    /// and the scene's own triangles.
    std::optional<SkyOverScene> sky;
    /// Where tables of skies are kept that several pictures share; null: they are this one's.
    SkyTableStore* skyTables = nullptr;
};

struct ReferencePicture {
    int width = 0;
    int height = 0;
    std::vector<glm::dvec3> surfaces;  ///< cd/m2, dimmed by the haze; rows from the top
    std::vector<glm::dvec3> beams;     ///< cd/m2
    std::vector<double> depths;  ///< metres along the view axis, infinity where nothing is hit

    /// Estimated error of a pixel's beams, divided by their largest channel: over all pixels the
    /// largest, and the root of the mean square.
    double largestError = 0.0;
    double rmsError = 0.0;
    SkyError skyError;  ///< estimated, of some pixels all over the picture; 0 without a sky

    glm::dvec3 total(std::size_t pixel) const { return surfaces[pixel] + beams[pixel]; }
};

/// Draws on all cores, stepping `progress` once for each row. The scene must outlive the call.
/// Points and lines are not seen by geometry's visibility; countUnseenPrimitives tells how many.
ReferencePicture drawReference(const Scene& scene, const ReferenceSettings& settings,
                               Progress* progress = nullptr);

/// The beams of a reference picture, pixel by pixel, in any order and from several threads at once.
class ReferencePixels {
  public:
    /// Both must outlive it, as what the settings point to, and stay as they are.
    ReferencePixels(const Scene& scene, const ReferenceSettings& settings);
    ~ReferencePixels();
    ReferencePixels(const ReferencePixels&) = delete;
    ReferencePixels& operator=(const ReferencePixels&) = delete;

    /// cd/m2; rows from the top. No pixel from two threads.
    glm::dvec3 beams(int x, int y);

  private:
    class Frame;
    std::unique_ptr<Frame> frame_;
};

/// How many of the scene's placed primitives are points or lines.
std::size_t countUnseenPrimitives(const Scene& scene);

}  // namespace ribalta
