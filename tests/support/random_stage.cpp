#include "support/random_stage.h"

#include <cmath>
#include <limits>
#include <random>

#include "support/stage.h"

namespace ribalta::test {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

class Dice {
  public:
    explicit Dice(unsigned seed) : engine_(seed) {}

    double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(engine_); }
    bool chance(double probability) { return share() < probability; }
    glm::dvec3 inCube(double halfSide) {
        const double x = halfSide * (2.0 * share() - 1.0);
        const double y = halfSide * (2.0 * share() - 1.0);
        return {x, y, halfSide * (2.0 * share() - 1.0)};
    }

  private:
    std::mt19937 engine_;
};

Image disc(double radius) {
    return makeImage(16, 16, [&](int x, int y) {
        return std::hypot(x - 7.5, y - 7.5) < 8.0 * radius ? glm::vec4(1.0F)
                                                           : glm::vec4(0, 0, 0, 1);
    });
}

}  // namespace

RandomStage::RandomStage(unsigned seed) {
    Dice dice(seed);
    for (int i = 0; i < 4; ++i) {
        Material material = makeMaterial(glm::vec3(0.5F));
        material.doubleSided = i % 2 == 0;
        const glm::dvec3 u = dice.inCube(6.0);
        const glm::dvec3 v = glm::cross(u, dice.inCube(1.0));
        addShape(scene, makeQuad(dice.inCube(5.0), u, v), material);
    }
    addShape(scene, makeBox({-0.5, -0.5, -0.5}, {0.5, 1, 0.5}), makeMaterial(glm::vec3(0.5F)));
    const glm::dvec3 eye = dice.inCube(7.0);
    camera = makeCamera(eye, dice.inCube(3.0), 0.3 + 1.2 * dice.share());
    camera.nearMetres = 0.05 + dice.share();
    camera.farMetres = dice.chance(0.4) ? camera.nearMetres + 12.0 * dice.share() : kEndless;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 place = dice.inCube(8.0);
        const glm::dvec3 target = dice.inCube(8.0);
        SpotLight lamp = makeSpot(place, target, 0.02 + 0.7 * dice.share());
        lamp.rangeMetres = dice.chance(0.6) ? 0.2 + 6.0 * dice.share() : kEndless;
        lamp.beamShape = dice.chance(0.5) ? BeamShape::kCone : BeamShape::kPyramid;
        if (dice.chance(0.4)) {
            useLightMap(scene, lamp, disc(0.9 * dice.share() - 0.1));
        }
        scene.spotLights.push_back(lamp);
    }
}

}  // namespace ribalta::test
