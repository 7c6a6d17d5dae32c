#include "scene/dial.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/scene.h"

namespace ribalta {
namespace {

using List = Dial::List;
using Numbers = Dial::Numbers;

constexpr double kEndless = std::numeric_limits<double>::infinity();

glm::dvec4 drawnNumbers(const Dial& dial) {
    glm::dvec4 drawn;
    for (int c = 0; c < 4; ++c) {
        drawn[c] = dial.unit * nearestDrawn(dial.numbers, c, dial.now[c]);
    }
    return drawn;
}

// What spots and point lights have both.
template <typename Lamp>
void bringToLamp(const Dial& dial, const glm::dvec4& drawn, Lamp& lamp) {
    if (dial.numbers == Numbers::kColor) {
        lamp.color = glm::vec3(drawn);
    } else if (dial.numbers == Numbers::kIntensity) {
        lamp.intensityCandela = drawn.x;
    } else if (dial.numbers == Numbers::kRange) {
        lamp.rangeMetres = drawn.x;
    }
}

void bringToSpot(const Dial& dial, const glm::dvec4& drawn, SpotLight& lamp) {
    bringToLamp(dial, drawn, lamp);
    if (dial.numbers == Numbers::kCone) {
        lamp.outerConeAngle = drawn.y;
        lamp.innerConeAngle = std::min(drawn.x, drawn.y);
    }
}

void bringToDirectional(const Dial& dial, const glm::dvec4& drawn, DirectionalLight& lamp) {
    if (dial.numbers == Numbers::kColor) {
        lamp.color = glm::vec3(drawn);
    } else if (dial.numbers == Numbers::kIntensity) {
        lamp.illuminanceLux = drawn.x;
    }
}

void bringToMaterial(const Dial& dial, const glm::dvec4& drawn, Material& material) {
    if (dial.numbers == Numbers::kBaseColor) {
        material.baseColor = glm::vec4(drawn);
    } else if (dial.numbers == Numbers::kEmission) {
        material.emission = glm::vec3(glm::dvec3(drawn) * drawn.w);
    }
}

}  // namespace

double nearestDrawn(Numbers numbers, int component, double value) {
    switch (numbers) {
        case Numbers::kVisible:
            return value;
        case Numbers::kColor:
            return std::clamp(value, 0.0, kMaxLampColor);
        case Numbers::kIntensity:
            return std::clamp(value, 0.0, kMaxLampIntensity);
        case Numbers::kRange:
            return value > 0.0 ? value : kEndless;
        case Numbers::kCone:
            return component == 0 ? std::clamp(value, 0.0, kMaxConeAngle)
                                  : std::clamp(value, kMinConeAngle, kMaxConeAngle);
        case Numbers::kFov:
            return std::clamp(value, kMinVerticalFov, kMaxVerticalFov);
        case Numbers::kAspect:
            return std::clamp(value, 1.0 / kMaxAspectRatio, kMaxAspectRatio);
        case Numbers::kDepth:
        case Numbers::kBoxDepth: {
            const double nearest = numbers == Numbers::kDepth ? kMinNearMetres : 0.0;
            return component == 1 && value >= kMaxCameraMetres
                       ? kEndless
                       : std::clamp(value, nearest, kMaxCameraMetres);
        }
        case Numbers::kExtent:
            return std::clamp(std::abs(value), kMinExtentMetres, kMaxCameraMetres);
        case Numbers::kBaseColor:
            return std::clamp(value, 0.0, 1.0);
        case Numbers::kEmission:
            return std::clamp(value, 0.0, component == 3 ? kMaxEmission : 1.0);
    }
    return value;
}

void bringTo(const Dial& dial, Camera& camera) {
    const glm::dvec4 drawn = drawnNumbers(dial);
    auto* perspective = std::get_if<PerspectiveLens>(&camera.lens);
    auto* box = std::get_if<OrthographicLens>(&camera.lens);
    if (perspective != nullptr && dial.numbers == Numbers::kFov) {
        perspective->verticalFov = drawn.x;
    } else if (perspective != nullptr && dial.numbers == Numbers::kAspect) {
        perspective->aspectRatio = drawn.x;
    } else if (perspective != nullptr && dial.numbers == Numbers::kDepth) {
        camera.nearMetres = drawn.x;
        camera.farMetres = drawn.y > drawn.x ? drawn.y : kEndless;
    } else if (box != nullptr && dial.numbers == Numbers::kBoxDepth) {
        const bool hasDepth = drawn.y > drawn.x && std::isfinite(drawn.y);
        camera.nearMetres = drawn.x;
        camera.farMetres = hasDepth ? drawn.y : drawn.x + kUsualBoxDepth * dial.unit;
    } else if (box != nullptr && dial.numbers == Numbers::kExtent) {
        box->halfWidth = drawn.x;
        box->halfHeight = drawn.y;
    }
}

void bringTo(const Dial& dial, Scene& scene) {
    const glm::dvec4 drawn = drawnNumbers(dial);
    for (const int owner : dial.owners) {
        const auto index = std::size_t(owner);
        switch (dial.list) {
            case List::kNodes:
                scene.nodes[index].visible = drawn.x != 0.0;
                break;
            case List::kSpotLights:
                bringToSpot(dial, drawn, scene.spotLights[index]);
                break;
            case List::kPointLights:
                bringToLamp(dial, drawn, scene.pointLights[index]);
                break;
            case List::kDirectionalLights:
                bringToDirectional(dial, drawn, scene.directionalLights[index]);
                break;
            case List::kCameras:
                bringTo(dial, scene.cameras[index]);
                break;
            case List::kMaterials:
                bringToMaterial(dial, drawn, scene.materials[index]);
                break;
        }
    }
}

}  // namespace ribalta
