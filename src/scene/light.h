// Lamps: KHR_lights_punctual's spot, point and directional lights, spots with light maps.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "scene/frame.h"

namespace ribalta {

/// A spot's half angles are kept within these when it is drawn (radians): one shadow map cannot
/// hold a half space, and below half a degree single precision has nothing left.
inline constexpr double kMinConeAngle = 0.00872664625997165;  // 0.5 degrees
inline constexpr double kMaxConeAngle = 1.39626340159546;     // 80 degrees

/// Brighter than any lamp by far, and products with it still fit single precision.
inline constexpr double kMaxLampIntensity = 1e12;  // candela or lux
inline constexpr double kMaxLampColor = 1e6;

/// The picture a lamp projects (gobo). Its square fills the cone's circle: the outer edge is the
/// outer cone angle. Seen from the lamp, the picture's top is local +Y, its right local +X.
struct LightMap {
    int image = -1;                ///< into Scene::images
    double rotationRadians = 0.0;  ///< counter-clockwise seen from the lamp

    bool operator==(const LightMap&) const = default;
};

enum class BeamShape {
    kCone,     ///< round, dimmed between the inner and the outer cone
    kPyramid,  ///< square, the light map's own edge; no cone falloff
};

struct SpotLight {
    std::string name;
    int node = -1;  ///< into Scene::nodes, -1 where made by hand
    Frame frame;
    glm::vec3 color{1.0F};  ///< linear
    double intensityCandela = 1.0;
    double innerConeAngle = 0.0;                ///< radians, half angle
    double outerConeAngle = 0.785398163397448;  ///< radians, half angle
    double rangeMetres = std::numeric_limits<double>::infinity();
    std::optional<LightMap> lightMap;
    BeamShape beamShape = BeamShape::kCone;
    bool shown = true;  ///< its node is; else it is dark

    bool operator==(const SpotLight&) const = default;
};

struct PointLight {
    std::string name;
    int node = -1;
    glm::dvec3 position{0.0};
    glm::vec3 color{1.0F};
    double intensityCandela = 1.0;
    double rangeMetres = std::numeric_limits<double>::infinity();
    bool shown = true;  ///< its node is; else it is dark

    bool operator==(const PointLight&) const = default;
};

struct DirectionalLight {
    std::string name;
    int node = -1;
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< the way the light travels, unit, world
    glm::vec3 color{1.0F};
    double illuminanceLux = 1.0;
    bool shown = true;  ///< its node is; else it is dark

    bool operator==(const DirectionalLight&) const = default;
};

}  // namespace ribalta
