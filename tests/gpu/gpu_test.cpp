// One context a process, made late and kept to the end, so that listing the tests needs none.
#include "gpu_test.h"

#include <cmath>

#include "gl/context.h"
#include "gl/debug_output.h"

namespace ribalta::test {

GpuTest::GpuTest() {
    static const Context context;
}

void GpuTest::TearDown() {
    glFinish();
    for (const std::string& error : takeGlErrors()) {
        ADD_FAILURE() << "OpenGL: " << error;
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

glm::dvec3 Frame3::color(int x, int y, const std::string& layer) const {
    const int first =
        image.channel(layer.empty() ? "R" : layer + (layer == "normal" ? ".X" : ".R"));
    return {image.at(x, y, first), image.at(x, y, first + 1), image.at(x, y, first + 2)};
}

Frame3 readBack(const Renderer& renderer, const FrameLayers& layers) {
    return {readFrame(renderer.lastPlan(), renderer.targets(), layers)};
}

Frame3 drawOnce(const Scene& scene, const Camera& camera, FrameSettings settings,
                const FrameLayers& layers) {
    settings.beamsOutput = settings.beamsOutput || layers.beams;
    settings.normalOutput = settings.normalOutput || layers.normal;
    Renderer renderer(scene);
    renderer.draw(camera, settings);
    return readBack(renderer, layers);
}

FrameSettings measuringSettings(int width, int height) {
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    settings.haze.scatteringPerMetre = 0.0;
    settings.ambientLux = 0.0;
    settings.display = false;
    return settings;
}

int countNotFinite(const Frame3& frame) {
    const std::size_t channels = frame.image.channels.size();
    const int depth = frame.image.channel("Z");
    int count = 0;
    for (std::size_t i = 0; i < frame.image.values.size(); ++i) {
        count += int(i % channels) != depth && !std::isfinite(frame.image.values[i]) ? 1 : 0;
    }
    return count;
}

}  // namespace ribalta::test
