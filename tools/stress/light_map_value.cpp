// Bilinear lookups, and the modulus of continuity of each map, found once.
#include "light_map_value.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "set_up.h"

namespace ribalta::stress {
namespace {

/// IEC 61966-2-1.
double linearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

const std::vector<glm::dvec3>& linearTexels(int index) {
    static const std::vector<std::vector<glm::dvec3>> maps = [] {
        std::vector<std::vector<glm::dvec3>> all;
        for (const Image& image : lightMaps()) {
            std::vector<glm::dvec3> texels(std::size_t(image.width) * std::size_t(image.height));
            for (std::size_t i = 0; i < texels.size(); ++i) {
                for (int c = 0; c < 3; ++c) {
                    texels[i][c] = linearFromSrgb(
                        std::to_integer<int>(image.pixels[4 * i + std::size_t(c)]) / 255.0);
                }
            }
            all.push_back(std::move(texels));
        }
        return all;
    }();
    return maps[std::size_t(index)];
}

glm::dvec3 texel(int index, int x, int y) {
    const int side = lightMapSide();
    const auto row = std::size_t(std::clamp(y, 0, side - 1));
    const auto column = std::size_t(std::clamp(x, 0, side - 1));
    return linearTexels(index)[row * std::size_t(side) + column];
}

double changeWithin(int index, int texels) {
    const int side = lightMapSide();
    double change = 0.0;
    // Along rows, columns and diagonals: what is farther apart by both is at most their sum.
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const glm::dvec3 here = texel(index, x, y);
            for (int step = 1; step <= texels; ++step) {
                for (const glm::ivec2 to : {glm::ivec2(step, 0), glm::ivec2(0, step),
                                            glm::ivec2(step, step), glm::ivec2(step, -step)}) {
                    const glm::dvec3 off = glm::abs(texel(index, x + to.x, y + to.y) - here);
                    change = std::max({change, off.x, off.y, off.z});
                }
            }
        }
    }
    return change;
}

}  // namespace

int lightMapSide() {
    return lightMaps().front().width;
}

glm::dvec3 lightMapValue(int index, const glm::dvec2& uv) {
    const int side = lightMapSide();
    const double x = std::clamp(uv.x * side - 0.5, 0.0, side - 1.0);
    const double y = std::clamp(uv.y * side - 0.5, 0.0, side - 1.0);
    const int left = int(x);
    const int top = int(y);
    return glm::mix(
        glm::mix(texel(index, left, top), texel(index, left + 1, top), x - left),
        glm::mix(texel(index, left, top + 1), texel(index, left + 1, top + 1), x - left), y - top);
}

double lightMapChange(int index, double texels) {
    static std::map<std::pair<int, int>, double> known;
    const int within = std::clamp(int(std::ceil(texels)), 1, lightMapSide());
    const auto [found, isNew] = known.try_emplace({index, within}, 0.0);
    if (isNew) {
        found->second = changeWithin(index, within);
    }
    return found->second;
}

}  // namespace ribalta::stress
