#include "gltf/project_web.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/angles.h"
#include "scene/light.h"

namespace ribalta::gltf {
namespace {

// Below this, what dims the edge of a cone reaches its axis.
constexpr double kNarrowest = 5.0 * kPi / 180.0;
constexpr double kNegligible = 0.001;

// Rings of half a degree, looked at in so many directions.
constexpr int kRings = 360;
constexpr int kSpokes = 180;

struct Ring {
    double brightest = 0.0;  // candela
    double lumens = 0.0;
};

std::vector<Ring> ringsOf(const PhotometricWeb& web) {
    std::vector<Ring> rings(kRings);
    for (int r = 0; r < kRings; ++r) {
        Ring& ring = rings[std::size_t(r)];
        const double off = kPi * (r + 0.5) / kRings;
        const double solidAngle = 2.0 * std::sin(off) * std::sin(0.5 * kPi / kRings) * 2.0 * kPi;
        for (int s = 0; s < kSpokes; ++s) {
            const double around = 2.0 * kPi * s / kSpokes;
            const double candela = web.at({std::sin(off) * std::cos(around),
                                           std::sin(off) * std::sin(around), -std::cos(off)});
            ring.brightest = std::max(ring.brightest, candela);
            ring.lumens += candela * solidAngle / kSpokes;
        }
    }
    return rings;
}

}  // namespace

ProjectedWeb projectWeb(const PhotometricWeb& web) {
    ProjectedWeb projected;
    const std::vector<Ring> rings = ringsOf(web);
    double brightest = 0.0;
    double lumens = 0.0;
    for (const Ring& ring : rings) {
        brightest = std::max(brightest, ring.brightest);
        lumens += ring.lumens;
    }
    double edge = 0.0;
    for (int r = 0; r < kRings; ++r) {
        if (rings[std::size_t(r)].brightest > kNegligible * brightest) {
            edge = kPi * (r + 1) / kRings;
        }
    }
    projected.halfAngle = std::clamp(edge, kNarrowest, kMaxConeAngle);
    double inside = 0.0;
    for (int r = 0; r < kRings && kPi * (r + 0.5) / kRings < projected.halfAngle; ++r) {
        inside += rings[std::size_t(r)].lumens;
    }
    projected.lostShare = lumens > 0.0 ? std::max(0.0, 1.0 - inside / lumens) : 0.0;

    const auto side = std::size_t(kWebMapSide);
    const double reach = std::tan(projected.halfAngle);
    std::vector<double> candela(side * side);
    for (std::size_t y = 0; y < side; ++y) {
        for (std::size_t x = 0; x < side; ++x) {
            const double right = (2.0 * (double(x) + 0.5) / double(side) - 1.0) * reach;
            const double up = (1.0 - 2.0 * (double(y) + 0.5) / double(side)) * reach;
            const double value = web.at(glm::normalize(glm::dvec3(right, up, -1.0)));
            candela[y * side + x] = value;
            if (right * right + up * up <= reach * reach) {
                projected.candela = std::max(projected.candela, value);
            }
        }
    }
    Image& map = projected.lightMap;
    map.width = map.height = kWebMapSide;
    map.type = Image::Type::kFloat32;
    map.pixels = RawBytes(side * side * map.bytesPerPixel());
    for (std::size_t i = 0; i < candela.size(); ++i) {
        const double share = projected.candela > 0.0 ? candela[i] / projected.candela : 0.0;
        const auto level = float(std::min(share, 1.0));
        const float pixel[4] = {level, level, level, 1.0F};
        std::memcpy(&map.pixels[i * sizeof pixel], pixel, sizeof pixel);
    }
    return projected;
}

}  // namespace ribalta::gltf
