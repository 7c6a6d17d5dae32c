// Dial: what animations change of lamps, cameras, materials and nodes, besides where they are
// (KHR_animation_pointer). Numbers that only make sense together are one dial's.
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace ribalta {

struct Camera;
struct Scene;

struct Dial {
    /// Whose it is: which of the scene's vectors `owners` count into.
    enum class List {
        kNodes,
        kSpotLights,
        kPointLights,
        kDirectionalLights,
        kCameras,
        kMaterials,
    };
    /// What its numbers x, y, z, w are, in glTF's units.
    enum class Numbers {
        kVisible,    ///< of a node: shown where not 0
        kColor,      ///< of a lamp: linear RGB
        kIntensity,  ///< of a lamp: candela, or lux where it is directional
        kRange,      ///< of a lamp: metres; unlimited where not above 0
        kCone,       ///< of a spot: inner, outer half angle, radians
        kFov,        ///< of a perspective camera: vertical, whole angle, radians
        kAspect,     ///< of a perspective camera: width / height
        kDepth,      ///< of a perspective camera: near, far
        kBoxDepth,   ///< of an orthographic camera: near, far
        kExtent,     ///< of an orthographic camera: half its width, half its height
        kBaseColor,  ///< of a material: linear RGBA
        kEmission,   ///< of a material: the factor's RGB, its strength
    };

    Numbers numbers = Numbers::kIntensity;
    List list = List::kSpotLights;
    std::vector<int> owners;  ///< all that share the file's one
    glm::dvec4 rest{0.0};     ///< as the file has them
    glm::dvec4 now{0.0};      ///< as they stand, in range or not
    double unit = 1.0;        ///< what they are multiplied by for the scene's own units
};

/// The nearest number to one of a dial's (0..3) that can be drawn.
double nearestDrawn(Dial::Numbers numbers, int component, double value);

/// Brings what the dial says to all its owners: its numbers as near as they can be drawn, the inner
/// cone within the outer, the far plane beyond the near one.
void bringTo(const Dial& dial, Scene& scene);
/// The same to one camera. The dial must be one of cameras; nothing happens where it is of the
/// other kind of lens.
void bringTo(const Dial& dial, Camera& camera);

}  // namespace ribalta
