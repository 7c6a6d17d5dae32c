#include "gltf/units.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace ribalta::gltf {
namespace {

// Fixtures of a rig hang within metres of each other, and the masts of a stadium, which stand
// farther apart, carry clusters of them: half of all lamps this far from their next one are in
// centimetres.
constexpr double kLonelyMetres = 30.0;
constexpr std::size_t kFewestForSpacing = 3;
// Spots compared with each other: the work grows with the square.
constexpr std::size_t kMostForSpacing = 1000;
// A household bulb has some 60 cd all around and a stage lamp 10,000 and more in its beam: spots
// that are all fainter than the bulb are numbers of another unit, such as Blender's without units,
// which are 683 times too small.
constexpr double kBulbCandela = 60.0;
constexpr std::size_t kFewestForIntensity = 2;

double medianSpacing(const std::vector<SpotLight>& lamps) {
    const std::size_t count = std::min(lamps.size(), kMostForSpacing);
    std::vector<double> nearest(count, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < count; ++k) {
            if (k != i) {
                nearest[i] = std::min(
                    nearest[i], glm::distance(lamps[i].frame.position, lamps[k].frame.position));
            }
        }
    }
    const auto middle = nearest.begin() + std::ptrdiff_t(count / 2);
    std::nth_element(nearest.begin(), middle, nearest.end());
    return *middle;
}

std::string shown(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", number);
    return text;
}

double unitOf(const LoadOptions& options, Dial::Numbers numbers) {
    switch (numbers) {
        case Dial::Numbers::kIntensity:
            return options.intensityScale;
        case Dial::Numbers::kRange:
        case Dial::Numbers::kDepth:
        case Dial::Numbers::kBoxDepth:
        case Dial::Numbers::kExtent:
            return options.unitScale;
        default:
            return 1.0;  // angles, colours and what is on or off
    }
}

}  // namespace

void scaleUnits(const LoadOptions& options, Scene& scene) {
    scene.unitMetres = options.unitScale;
    for (Dial& dial : scene.dials) {
        dial.unit = unitOf(options, dial.numbers);
    }
    for (Camera& camera : scene.cameras) {
        camera.nearMetres *= options.unitScale;
        camera.farMetres *= options.unitScale;
        if (auto* box = std::get_if<OrthographicLens>(&camera.lens)) {
            box->halfWidth *= options.unitScale;
            box->halfHeight *= options.unitScale;
        }
    }
    if (scene.environment) {
        for (glm::dmat4& form : scene.environment->lux) {
            form *= options.intensityScale;
        }
    }
    for (SpotLight& lamp : scene.spotLights) {
        lamp.rangeMetres *= options.unitScale;
        lamp.intensityCandela *= options.intensityScale;
    }
    for (PointLight& lamp : scene.pointLights) {
        lamp.rangeMetres *= options.unitScale;
        lamp.intensityCandela *= options.intensityScale;
    }
    for (DirectionalLight& lamp : scene.directionalLights) {
        lamp.illuminanceLux *= options.intensityScale;
    }
}

void hintAtUnits(const LoadOptions& options, const Place& file, const Scene& scene,
                 Report& report) {
    const std::vector<SpotLight>& lamps = scene.spotLights;
    if (options.unitScale == 1.0 && lamps.size() >= kFewestForSpacing) {
        const double spacing = medianSpacing(lamps);
        if (spacing >= kLonelyMetres) {
            report.hint(file, "half of its spots hang " + shown(spacing) +
                                  " m or more from the next one, as if centimetres were taken for "
                                  "metres; --unit-scale 0.01 would read it so");
        }
    }
    // What they have at rest says nothing of lamps that are animated.
    const bool areDialed =
        std::any_of(scene.dials.begin(), scene.dials.end(),
                    [](const Dial& dial) { return dial.numbers == Dial::Numbers::kIntensity; });
    if (options.intensityScale == 1.0 && lamps.size() >= kFewestForIntensity && !areDialed) {
        double brightest = 0.0;
        for (const SpotLight& lamp : lamps) {
            brightest = std::max(brightest, lamp.intensityCandela);
        }
        if (brightest > 0.0 && brightest < kBulbCandela) {
            report.hint(file, "its brightest spot has " + shown(brightest) +
                                  " cd, less than a household bulb, as if exported without "
                                  "physical units; export with them (Blender: Lighting Mode "
                                  "Standard), or --intensity-scale 683 would read it so");
        }
    }
}

}  // namespace ribalta::gltf
