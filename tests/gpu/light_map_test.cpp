// Light maps and textures the right way up: an asymmetric picture on the floor, in the haze and on
// a surface; and that filtering takes no light away.
#include <cmath>

#include "gpu_test.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

const glm::vec4 kRed(1, 0, 0, 1);
const glm::vec4 kGreen(0, 1, 0, 1);
const glm::vec4 kBlue(0, 0, 1, 1);
const glm::vec4 kYellow(1, 1, 0, 1);

/// Red and green on top, blue and yellow below.
Image quadrants(int side = 64) {
    return makeImage(side, side, [side](int x, int y) {
        const bool left = x < side / 2;
        return y < side / 2 ? (left ? kRed : kGreen) : (left ? kBlue : kYellow);
    });
}

/// 'r', 'g', 'b', 'y', '.' where dark, '?' for any other mixture.
char colorName(const glm::dvec3& color) {
    const double peak = std::max({color.x, color.y, color.z});
    if (peak <= 0.0) {
        return '.';
    }
    const glm::dvec3 share = color / peak;
    const auto is = [&](double r, double g, double b) {
        return glm::length(share - glm::dvec3(r, g, b)) < 0.1;
    };
    return is(1, 0, 0) ? 'r' : is(0, 1, 0) ? 'g' : is(0, 0, 1) ? 'b' : is(1, 1, 0) ? 'y' : '?';
}

/// The names in the middles of a picture's four quarters: top left, top right, bottom left, right.
std::string quarters(const Frame3& frame, const std::string& layer = "") {
    const int w = frame.image.width;
    const int h = frame.image.height;
    std::string names;
    for (const int y : {3 * h / 8, 5 * h / 8}) {
        for (const int x : {3 * w / 8, 5 * w / 8}) {
            names += colorName(frame.color(x, y, layer));
        }
    }
    return names;
}

class LightMapTest : public GpuTest {
  protected:
    LightMapTest() {
        // Shines straight down; its up is -Z and its right +X.
        lamp_.frame = lookAt({0, 4, 0}, {0, 0, 0}, {0, 0, -1});
        lamp_.outerConeAngle = 0.5;
        lamp_.innerConeAngle = 0.5;
        lamp_.intensityCandela = 1000.0;
    }

    void addFloor() {
        addShape(scene_, makeQuad({0, 0, 0}, {6, 0, 0}, {0, 0, -6}), makeMaterial(glm::vec3(0.5F)));
    }
    /// A camera that sees the floor as the lamp does.
    Camera fromAbove(double height) const {
        Camera camera;
        camera.frame = lamp_.frame;
        camera.frame.position.y = height;
        camera.lens = PerspectiveLens{2.0 * std::atan(std::tan(0.5) * 4.0 / height), {}};
        return camera;
    }

    Scene scene_;
    SpotLight lamp_;
    FrameSettings settings_ = measuringSettings(64, 64);
};

TEST_F(LightMapTest, TheFrameOfTheLampIsAsSaid) {
    EXPECT_LT(glm::length(lamp_.frame.right() - glm::dvec3(1, 0, 0)), 1e-12);
    EXPECT_LT(glm::length(lamp_.frame.up() - glm::dvec3(0, 0, -1)), 1e-12);
}

TEST_F(LightMapTest, OnTheFloorAsSeenFromTheLamp) {
    addFloor();
    const std::pair<double, const char*> turns[] = {
        {0.0, "rgby"}, {0.5 * M_PI, "gyrb"}, {M_PI, "ybgr"}, {-0.5 * M_PI, "bryg"}};
    for (const auto& [rotation, expected] : turns) {
        useLightMap(scene_, lamp_, quadrants(), rotation);
        scene_.spotLights = {lamp_};
        // A rotation of 90 degrees counter-clockwise brings the top right to the top left.
        EXPECT_EQ(quarters(drawOnce(scene_, fromAbove(8.0), settings_)), expected) << rotation;
    }
}

TEST_F(LightMapTest, InTheHazeAsSeenFromTheLamp) {
    settings_.haze.scatteringPerMetre = 0.05;
    FrameLayers layers;
    layers.beams = true;
    const std::pair<double, const char*> turns[] = {{0.0, "rgby"}, {0.5 * M_PI, "gyrb"}};
    for (const auto& [rotation, expected] : turns) {
        useLightMap(scene_, lamp_, quadrants(), rotation);
        scene_.spotLights = {lamp_};
        for (const auto method : {BeamMethod::kClipped, BeamMethod::kPlanes}) {
            settings_.beams.method = method;
            // From the lamp itself every ray keeps to one direction of the light map. The near
            // plane stands beyond the lens.
            EXPECT_EQ(quarters(drawOnce(scene_, fromAbove(4.001), settings_, layers), "beams"),
                      expected)
                << rotation;
        }
    }
}

TEST_F(LightMapTest, InTheHazeFromTheSide) {
    useLightMap(scene_, lamp_, quadrants());
    scene_.spotLights = {lamp_};
    settings_.haze.scatteringPerMetre = 0.05;
    FrameLayers layers;
    layers.beams = true;
    // From +Z: to the left red and blue behind one another, to the right green and yellow.
    const Frame3 frame = drawOnce(scene_, makeCamera({0, 2, 8}, {0, 2, 0}, 0.3), settings_, layers);
    const glm::dvec3 left = frame.color(24, 32, "beams");
    const glm::dvec3 right = frame.color(40, 32, "beams");
    EXPECT_GT(left.x, 0.0);
    EXPECT_GT(left.z, 0.0);
    EXPECT_LT(left.y, 0.01 * left.x);
    EXPECT_GT(right.y, right.x);
    EXPECT_GT(right.x, 0.0);
    EXPECT_LT(right.z, 0.01 * right.y);
}

double sumOf(const Frame3& frame, const std::string& layer = "") {
    double sum = 0.0;
    for (int y = 0; y < frame.image.height; ++y) {
        for (int x = 0; x < frame.image.width; ++x) {
            sum += frame.color(x, y, layer).x;
        }
    }
    return sum;
}

TEST_F(LightMapTest, FilteringKeepsTheMeanBrightness) {
    // A chequer of single texels of 0 and 1, encoded; its mean light is a half, sRGB 188.
    const Image chequer = makeImage(512, 512, [](int x, int y) {
        return glm::vec4(glm::vec3((x + y) % 2 == 0 ? 1.0F : 0.0F), 1.0F);
    });
    const Image even =
        makeImage(16, 16, [](int, int) { return glm::vec4(glm::vec3(188.0F / 255.0F), 1.0F); });
    addFloor();
    settings_.haze.scatteringPerMetre = 0.05;
    FrameLayers layers;
    layers.beams = true;
    const Camera cameras[] = {makeCamera({1, 3, 9}, {0, 1.5, 0}),
                              makeCamera({0.3, 2, 0.5}, {1, 0, -1}),
                              makeCamera({0.2, 0.4, 0.5}, {0, 4, 0})};
    for (const Camera& camera : cameras) {
        double beams[2] = {};
        double floor[2] = {};
        for (const int i : {0, 1}) {
            useLightMap(scene_, lamp_, i == 0 ? chequer : even);
            scene_.spotLights = {lamp_};
            const Frame3 frame = drawOnce(scene_, camera, settings_, layers);
            beams[i] = sumOf(frame, "beams");
            floor[i] = sumOf(frame) - beams[i];
        }
        EXPECT_NEAR(beams[0], beams[1], 0.05 * beams[1]);
        EXPECT_NEAR(floor[0], floor[1], 0.05 * floor[1]);
    }
}

TEST_F(LightMapTest, MapsOfDifferentSizesKeepTheirLampsAndColours) {
    addFloor();
    // Two lamps side by side; the smaller picture is stretched to the larger one's layer.
    SpotLight left = lamp_;
    SpotLight right = lamp_;
    left.outerConeAngle = left.innerConeAngle = right.outerConeAngle = right.innerConeAngle = 0.2;
    left.frame.position.x = -1.0;
    right.frame.position.x = 1.0;
    useLightMap(scene_, left, makeImage(16, 16, [](int, int) {
                    return glm::vec4(glm::vec3(188.0F / 255.0F), 1.0F);
                }));
    useLightMap(scene_, right,
                makeImage(200, 100, [](int x, int) { return x < 100 ? kRed : kBlue; }));
    scene_.spotLights = {left, right};
    const Frame3 frame = drawOnce(scene_, fromAbove(8.0), settings_);
    scene_.spotLights[0].lightMap.reset();
    const Frame3 white = drawOnce(scene_, fromAbove(8.0), settings_);
    // The picture is 4.37 m high, so that a metre is 14.6 pixels: the lamps' middles.
    EXPECT_NEAR(frame.color(17, 32).x, 0.503 * white.color(17, 32).x, 0.01 * white.color(17, 32).x);
    EXPECT_EQ(colorName(frame.color(43, 32)), 'r');
    EXPECT_EQ(colorName(frame.color(50, 32)), 'b');
}

TEST_F(LightMapTest, TexturesStandUprightAndAreDecoded) {
    scene_.images = {quadrants(), makeImage(4, 4, [](int, int) {
                         return glm::vec4(glm::vec3(188.0F / 255.0F), 1.0F);
                     })};
    for (const int image : {0, 1}) {
        Texture texture;
        texture.image = image;
        scene_.textures.push_back(texture);
    }
    Material material = makeMaterial(glm::vec3(1.0F));
    material.unlit = true;
    material.baseColorTexture = TextureSlot{};
    material.baseColorTexture->texture = 0;
    addShape(scene_, makeQuad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), material);
    const Camera camera = makeCamera({0, 0, 3}, {0, 0, 0}, 2.0 * std::atan(1.0 / 3.0));
    EXPECT_EQ(quarters(drawOnce(scene_, camera, settings_)), "rgby");
    scene_.materials[0].baseColorTexture->texture = 1;
    EXPECT_NEAR(drawOnce(scene_, camera, settings_).color(20, 20).x, 0.503, 0.003);
}

}  // namespace
}  // namespace ribalta::test
