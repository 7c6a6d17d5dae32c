// Camera: glTF's two projections (section 3.10) and the rays through a picture.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>

#include <glm/glm.hpp>

#include "scene/bounds.h"
#include "scene/frame.h"

namespace ribalta {

/// What a camera of a file may have; what of it makes no picture is mended.
inline constexpr double kMinVerticalFov = 1e-4;  // radians, whole angle
inline constexpr double kMaxVerticalFov = 3.1;   // short of a half space
inline constexpr double kMaxAspectRatio = 1e4;   // and its inverse
inline constexpr double kMinNearMetres = 1e-9;   // perspective; a box may begin at 0
inline constexpr double kMinExtentMetres = 1e-9;
inline constexpr double kMaxCameraMetres = 1e30;
inline constexpr double kUsualBoxDepth = 100.0;  // metres, of an orthographic camera without one

struct PerspectiveLens {
    double verticalFov = 0.8;           ///< radians, whole angle
    std::optional<double> aspectRatio;  ///< the author's; see viewHalfExtent
    bool operator==(const PerspectiveLens&) const = default;
};

struct OrthographicLens {
    double halfWidth = 1.0;   ///< metres (xmag)
    double halfHeight = 1.0;  ///< metres (ymag)
    bool operator==(const OrthographicLens&) const = default;
};

struct Camera {
    std::string name;
    int node = -1;  ///< into Scene::nodes, -1 where made by hand
    Frame frame;
    std::variant<PerspectiveLens, OrthographicLens> lens;
    double nearMetres = 0.1;
    double farMetres = std::numeric_limits<double>::infinity();  ///< finite where orthographic

    bool isOrthographic() const { return std::holds_alternative<OrthographicLens>(lens); }
    bool operator==(const Camera&) const = default;
};

/// Half the view's extent at unit distance (perspective) or in metres (orthographic) for a picture
/// of `width` x `height` pixels. A picture narrower than the author's aspect ratio keeps the
/// author's width, so that nothing framed is cut off; a wider one keeps the height.
glm::dvec2 viewHalfExtent(const Camera& camera, int width, int height);

/// Clip space from world, reversed depth in 0..1 (1 at the near plane, 0 at infinity or `far`).
glm::dmat4 clipFromWorld(const Camera& camera, int width, int height);

/// World from the camera's own axes (x right, y up, looking along -z).
glm::dmat4 worldFromView(const Camera& camera);
glm::dmat4 viewFromWorld(const Camera& camera);

/// A camera that sees the whole of `bounds` from the front, a little above (the file has none).
Camera makeFramingCamera(const Bounds& bounds, double aspectRatio);

}  // namespace ribalta
