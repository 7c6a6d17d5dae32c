// A light map's texels by hand: decoding, filtering, edges.
#include "reference/light_map_texture.h"

#include <array>
#include <cstring>

#include <gtest/gtest.h>

namespace ribalta {
namespace {

Image makeImage(int width, int height, std::initializer_list<std::array<int, 3>> texels) {
    Image image;
    image.width = width;
    image.height = height;
    image.pixels = RawBytes(texels.size() * 4);
    std::byte* to = image.pixels.data();
    for (const std::array<int, 3>& texel : texels) {
        for (const int channel : texel) {
            *to++ = std::byte(channel);
        }
        *to++ = std::byte(0);
    }
    return image;
}

void expectNear(const glm::dvec3& value, const glm::dvec3& expected) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(value[c], expected[c], 1e-6);
    }
}

const Image kCorners = makeImage(2, 2, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {128, 128, 128}});

TEST(LightMapTexture, TexelCentresAreTheTexels) {
    const LightMapTexture map(kCorners);
    expectNear(map.at({0.25, 0.25}), {1.0, 0.0, 0.0});
    expectNear(map.at({0.75, 0.25}), {0.0, 1.0, 0.0});
    expectNear(map.at({0.25, 0.75}), {0.0, 0.0, 1.0});
    expectNear(map.at({0.75, 0.75}), glm::dvec3(0.2158605));
}

TEST(LightMapTexture, FiltersAfterDecoding) {
    const LightMapTexture map(kCorners);
    expectNear(map.at({0.5, 0.25}), {0.5, 0.5, 0.0});
    expectNear(map.at({0.375, 0.25}), {0.75, 0.25, 0.0});
    expectNear(map.at({0.5, 0.5}), glm::dvec3((1.0 + 0.2158605) / 4.0));
}

TEST(LightMapTexture, IsClampedToItsEdge) {
    const LightMapTexture map(kCorners);
    expectNear(map.at({0.0, 0.0}), {1.0, 0.0, 0.0});
    expectNear(map.at({-3.0, 0.1}), {1.0, 0.0, 0.0});
    expectNear(map.at({2.0, 9.0}), glm::dvec3(0.2158605));
}

TEST(LightMapTexture, FloatsAreLinearAlready) {
    Image image;
    image.width = 1;
    image.height = 1;
    image.type = Image::Type::kFloat32;
    const std::array<float, 4> texel = {2.5F, 0.5F, 0.0F, 1.0F};
    image.pixels = RawBytes(sizeof texel);
    std::memcpy(image.pixels.data(), texel.data(), sizeof texel);
    expectNear(LightMapTexture(image).at({0.3, 0.8}), {2.5, 0.5, 0.0});
}

}  // namespace
}  // namespace ribalta
