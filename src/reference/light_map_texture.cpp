// Decoding and bilinear filtering of light maps in the order in which OpenGL does them.
#include "reference/light_map_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

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

/// How much of a texel of a row goes into one of the row's smaller copy.
struct Share {
    std::size_t from;
    std::size_t to;
    double weight;
};

std::vector<Share> sharesOfHalf(int count, int smaller) {
    std::vector<Share> shares;
    const double width = double(count) / smaller;
    for (int to = 0; to < smaller; ++to) {
        const double first = to * width;
        const double last = first + width;
        for (int from = int(first); from < count && from < last; ++from) {
            const double part = std::min(last, from + 1.0) - std::max(first, double(from));
            shares.push_back({std::size_t(from), std::size_t(to), part / width});
        }
    }
    return shares;
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

LightMapTexture::LightMapTexture(int width, int height, std::vector<glm::vec4> texels)
    : width_(width), height_(height), texels_(std::move(texels)) {
    findDark();
}

LightMapTexture LightMapTexture::halved() const {
    const int width = std::max(1, width_ / 2);
    const int height = std::max(1, height_ / 2);
    const std::vector<Share> columns = sharesOfHalf(width_, width);
    const std::vector<Share> rows = sharesOfHalf(height_, height);
    std::vector<glm::vec4> texels(std::size_t(width) * std::size_t(height), glm::vec4(0.0F));
    for (const Share& row : rows) {
        for (const Share& column : columns) {
            texels[row.to * std::size_t(width) + column.to] +=
                float(row.weight * column.weight) *
                texels_[row.from * std::size_t(width_) + column.from];
        }
    }
    return {width, height, std::move(texels)};
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
