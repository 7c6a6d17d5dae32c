// RandomStage: walls, a box, lamps of every kind and a camera, put together at random; most of it
// is in someone's way. Draws nothing itself.
#pragma once

#include "scene/camera.h"
#include "scene/scene.h"

namespace ribalta::test {

/// Equal seeds give equal stages. Eight lamps, some with a range, some with a light map whose rim
/// or all of it is black; cameras with and without a far plane.
struct RandomStage {
    explicit RandomStage(unsigned seed);

    Scene scene;
    Camera camera;
};

}  // namespace ribalta::test
