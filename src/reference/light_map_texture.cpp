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
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(&texels_[i], image.pixels.data() + i * image.bytesPerPixel(),
                    sizeof(glm::vec3));
    }
}

glm::dvec3 LightMapTexture::at(const glm::dvec2& uv) const {
    const double x = glm::clamp(uv.x * width_ - 0.5, 0.0, width_ - 1.0);
    const double y = glm::clamp(uv.y * height_ - 0.5, 0.0, height_ - 1.0);
    const int left = int(x);
    const int top = int(y);
    const int right = std::min(left + 1, width_ - 1);
    const int bottom = std::min(top + 1, height_ - 1);
    const auto texel = [&](int column, int row) {
        return glm::dvec3(texels_[std::size_t(row) * std::size_t(width_) + std::size_t(column)]);
    };
    const glm::dvec3 upper = glm::mix(texel(left, top), texel(right, top), x - left);
    const glm::dvec3 lower = glm::mix(texel(left, bottom), texel(right, bottom), x - left);
    return glm::mix(upper, lower, y - top);
}

}  // namespace ribalta
