// Decoding and bilinear filtering of light maps in the order in which OpenGL does them.
#include "reference/light_map_texture.h"

#include <array>
#include <cmath>
#include <cstring>

#include "base/check.h"
#include "optics/shader_lib.h"

namespace ribalta {
namespace {

std::array<float, 256> srgbTable() {
    std::array<float, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i) {
        linear[i] = float(shader::srgbDecodeChannel(double(i) / 255.0));
    }
    return linear;
}

}  // namespace

LightMapTexture::LightMapTexture(const Image& image) : width_(image.width), height_(image.height) {
    CHECK(width_ > 0 && height_ > 0);
    const std::size_t count = std::size_t(width_) * std::size_t(height_);
    CHECK(image.pixels.size() == count * image.bytesPerPixel());
    texels_.resize(count);
    if (image.type == Image::Type::kUint8) {
        const std::array<float, 256> linear = srgbTable();
        for (std::size_t i = 0; i < count; ++i) {
            for (int c = 0; c < 3; ++c) {
                texels_[i][c] = linear[std::to_integer<std::size_t>(image.pixels[4 * i + c])];
            }
        }
        findDark();
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(&texels_[i], image.pixels.data() + i * image.bytesPerPixel(),
                    sizeof(glm::vec3));
    }
    findDark();
}

void LightMapTexture::findDark() {
    dark_.reserve((std::size_t(width_) + 1) * (std::size_t(height_) + 1));
    for (int row = -1; row < height_; ++row) {
        for (int column = -1; column < width_; ++column) {
            bool dark = true;
            for (const glm::vec4* corner : cell(column, row).corners) {
                dark = dark && glm::vec3(*corner) == glm::vec3(0.0F);
            }
            dark_.push_back(dark ? 1 : 0);
        }
    }
}

glm::dvec3 LightMapTexture::at(const glm::dvec2& uv) const {
    const double x = glm::clamp(uv.x * width_ - 0.5, 0.0, width_ - 1.0);
    const double y = glm::clamp(uv.y * height_ - 0.5, 0.0, height_ - 1.0);
    const int left = int(x);
    const int top = int(y);
    const Cell around = cell(left, top);
    const auto corner = [&](std::size_t i) { return glm::dvec3(*around.corners[i]); };
    const glm::dvec3 upper = glm::mix(corner(0), corner(1), x - left);
    const glm::dvec3 lower = glm::mix(corner(2), corner(3), x - left);
    return glm::mix(upper, lower, y - top);
}

}  // namespace ribalta
