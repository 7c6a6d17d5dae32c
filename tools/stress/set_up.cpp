// Moving a set-up, telling its numbers, and the pictures its lamps project.
#include "set_up.h"

#include <cmath>
#include <cstdio>
#include <sstream>

#include "base/angles.h"
#include "make_set_up.h"

namespace ribalta::stress {
namespace {

constexpr int kSide = 64;

template <typename Value>
Image makeMap(const char* name, Value value) {
    Image image;
    image.name = name;
    image.width = kSide;
    image.height = kSide;
    image.pixels = RawBytes(std::size_t(kSide) * kSide * 4);
    std::byte* to = image.pixels.data();
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            for (int c = 0; c < 4; ++c) {
                const double level = c == 3 ? 1.0 : value(x, y, c);
                *to++ = std::byte(int(std::lround(255.0 * level)));
            }
        }
    }
    return image;
}

Frame movedFrame(const Frame& frame, const glm::dmat3& rotation, const glm::dvec3& metres) {
    return {rotation * frame.position + metres, rotation * frame.worldFromLocal};
}

std::string text(const glm::dvec3& v) {
    char line[96];
    std::snprintf(line, sizeof line, "(%.17g, %.17g, %.17g)", v.x, v.y, v.z);
    return line;
}

std::string text(const Frame& frame) {
    return text(frame.position) + ", looks " + text(frame.forward()) + ", up " + text(frame.up());
}

}  // namespace

const std::vector<Image>& lightMaps() {
    static const std::vector<Image> maps = {
        makeMap("smooth",
                [](int x, int y, int c) {
                    return 0.5 + 0.25 * std::sin(0.08 * x + c) + 0.2 * std::cos(0.1 * y - c);
                }),
        makeMap("chequered",
                [](int x, int y, int c) { return (x / 8 + y / 8 + c) % 2 == 0 ? 1.0 : 0.0; }),
        makeMap("spokes", [](int x, int y, int /*c*/) {
            return std::sin(9.0 * std::atan2(y - 31.5, x - 31.5)) > 0.0 ? 1.0 : 0.0;
        })};
    return maps;
}

SetUp moved(const SetUp& setUp, const glm::dmat3& rotation, const glm::dvec3& metres) {
    SetUp result = setUp;
    for (SpotLight& lamp : result.lamps) {
        lamp.frame = movedFrame(lamp.frame, rotation, metres);
    }
    for (Rectangle& rectangle : result.rectangles) {
        rectangle.centre = rotation * rectangle.centre + metres;
        rectangle.halfU = rotation * rectangle.halfU;
        rectangle.halfV = rotation * rectangle.halfV;
    }
    result.camera.frame = movedFrame(result.camera.frame, rotation, metres);
    return result;
}

std::string describe(const SetUp& setUp) {
    std::ostringstream out;
    out.precision(17);
    out << "seed " << setUp.seed << ", case " << setUp.number << ", " << kindNames()[setUp.kind]
        << ": " << setUp.width << "x" << setUp.height << " pixels, " << setUp.sheets
        << " sheets\n  haze: scattering " << setUp.haze.scatteringPerMetre << ", absorption "
        << setUp.haze.absorptionPerMetre << " 1/m, phase function " << int(setUp.haze.phase.kind)
        << ", g " << setUp.haze.phase.g << "\n  camera at " << text(setUp.camera.frame) << ", near "
        << setUp.camera.nearMetres << ", far " << setUp.camera.farMetres;
    const glm::dvec2 half = viewHalfExtent(setUp.camera, setUp.width, setUp.height);
    out << (setUp.camera.isOrthographic() ? ", orthographic" : ", perspective") << ", half extent "
        << half.x << " x " << half.y << "\n";
    for (const SpotLight& lamp : setUp.lamps) {
        out << "  lamp at " << text(lamp.frame) << "\n    "
            << (lamp.beamShape == BeamShape::kCone ? "cone" : "pyramid") << ", half angles "
            << lamp.innerConeAngle / kDegree << ", " << lamp.outerConeAngle / kDegree
            << " degrees, " << lamp.intensityCandela << " cd " << text(glm::dvec3(lamp.color))
            << ", range " << lamp.rangeMetres << " m";
        if (lamp.lightMap) {
            out << ", light map " << lamp.lightMap->image << " turned by "
                << lamp.lightMap->rotationRadians;
        }
        out << "\n";
    }
    for (const Rectangle& rectangle : setUp.rectangles) {
        out << "  rectangle at " << text(rectangle.centre) << ", half sides "
            << text(rectangle.halfU) << ", " << text(rectangle.halfV) << "\n";
    }
    return out.str();
}

}  // namespace ribalta::stress
