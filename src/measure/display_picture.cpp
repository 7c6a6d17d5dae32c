#include "measure/display_picture.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/parallel_for.h"
#include "optics/shader_lib.h"

namespace ribalta {

namespace {

glm::dvec3 shown(const glm::dvec3& exposed, ToneCurve curve) {
    return shader::srgbEncode(shader::tonemap(int(curve), exposed));
}

}  // namespace

glm::dvec3 displayPixel(const glm::dvec3& linear, double ev100, ToneCurve curve) {
    return shown(linear * shader::exposureFromEv100(ev100), curve);
}

RgbPicture displayPicture(const RgbPicture& linear, double ev100, ToneCurve curve) {
    RgbPicture display{linear.width, linear.height, {}};
    display.pixels.resize(linear.pixels.size());
    const double exposure = shader::exposureFromEv100(ev100);
    const auto width = std::size_t(linear.width);
    parallelFor(std::size_t(linear.height), [&](std::size_t y) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
            display.pixels[i] = glm::vec3(shown(glm::dvec3(linear.pixels[i]) * exposure, curve));
        }
    });
    return display;
}

double autoExposure(const RgbPicture& linear) {
    std::array<std::uint32_t, std::size_t(shader::kExposureBins)> bins{};
    std::uint32_t lit = 0;
    const int across = std::min(linear.width, shader::kExposureGridAcross);
    const int down = std::min(linear.height, shader::kExposureGridDown);
    for (int j = 0; j < down; ++j) {
        // The renderer counts its rows from below.
        const int y = linear.height - 1 - j * linear.height / down;
        for (int i = 0; i < across; ++i) {
            const int bin = shader::exposureBin(linear.at(i * linear.width / across, y));
            if (bin >= 0) {
                ++bins[std::size_t(bin)];
                ++lit;
            }
        }
    }
    if (lit == 0) {
        return shader::ev100OfStops(0.0, 0.0, false);
    }
    std::uint32_t burnt = 0;
    int top = shader::kExposureBins - 1;
    const auto mayBurn = std::uint32_t(shader::kExposureBurnt * double(lit));
    while (top > 0 && burnt + bins[std::size_t(top)] <= mayBurn) {
        burnt += bins[std::size_t(top)];
        --top;
    }
    double weight = 0.0;
    double sum = 0.0;
    for (int i = std::max(0, top - shader::kExposureBinsLookedAt); i < shader::kExposureBins; ++i) {
        weight += bins[std::size_t(i)];
        sum += bins[std::size_t(i)] * (std::min(i, top) + 0.5);
    }
    return shader::ev100OfStops(top + 1.0, weight > 0.0 ? sum / weight : top + 1.0, true);
}

}  // namespace ribalta
