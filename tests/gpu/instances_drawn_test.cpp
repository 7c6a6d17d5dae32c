// Many places of one mesh: one call, and the picture of as many meshes of their own.
#include "gl/counters.h"
#include "gpu_test.h"
#include "support/stage.h"

namespace ribalta::test {
namespace {

class Instances : public GpuTest {
  protected:
    // Boxes on a floor in a spot's light, some of them mirrored; each with a mesh of its own or
    // not.
    static Scene boxes(bool shared) {
        Scene scene;
        addShape(scene, makeQuad({0, 0, 0}, {6, 0, 0}, {0, 0, -6}), makeMaterial(glm::vec3(0.5F)));
        for (int i = 0; i < 20; ++i) {
            glm::dmat4 place(1.0);
            place[0][0] = i % 5 == 0 ? -1.0 : 1.0;
            place[1][1] = 1.0 + 0.1 * i;
            place[3] = glm::dvec4(-4.0 + 2.0 * (i % 5), 0.0, -4.0 + 2.0 * (i / 5), 1.0);
            if (shared && i > 0) {
                Node node;
                node.mesh = 1;
                node.parentFromLocal = place;
                scene.nodes.push_back(node);
            } else {
                addShape(scene, makeBox({-0.4F, 0.0F, -0.4F}, {0.4F, 0.6F, 0.3F}),
                         makeMaterial({0.8F, 0.4F, 0.1F}), place);
            }
        }
        placeNodes(scene);
        scene.spotLights.push_back(makeSpot({2, 8, 3}, {0, 0, 0}, 0.7));
        return scene;
    }
};

TEST_F(Instances, AreDrawnAsMeshesOfTheirOwnWouldBe) {
    FrameSettings settings = measuringSettings(160, 120);
    settings.ambientLux = 2.0;
    settings.haze.scatteringPerMetre = 0.02;
    const Camera camera = makeCamera({1, 6, 9}, {0, 0, 0});
    const auto callsOf = [&](const Scene& scene, Frame3& frame) {
        Renderer renderer(scene);
        const std::uint64_t before = glCounters().drawCalls;
        renderer.draw(camera, settings);
        const std::uint64_t calls = glCounters().drawCalls - before;
        frame = readBack(renderer);
        return calls;
    };
    Frame3 together;
    Frame3 apart;
    const std::uint64_t few = callsOf(boxes(true), together);
    const std::uint64_t many = callsOf(boxes(false), apart);
    // Of floor, boxes and mirrored boxes each three in the shadow map and in the picture, where
    // there were 21.
    EXPECT_EQ(many - few, 2U * (21U - 3U));
    double most = 0.0;
    for (int y = 0; y < settings.height; ++y) {
        for (int x = 0; x < settings.width; ++x) {
            ASSERT_EQ(together.color(x, y), apart.color(x, y)) << x << ' ' << y;
            most = std::max(most, apart.color(x, y).x);
        }
    }
    EXPECT_GT(most, 1.0);
}

}  // namespace
}  // namespace ribalta::test
