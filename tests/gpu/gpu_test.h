// GpuTest: a test with an OpenGL context that fails on any complaint of OpenGL; and frames drawn
// and read back in one step.
#pragma once

#include <gtest/gtest.h>

#include "image/image.h"
#include "render/read_frame.h"
#include "render/renderer.h"

namespace ribalta::test {

class GpuTest : public testing::Test {
  protected:
    /// Makes the process's one context if this is its first test.
    GpuTest();
    /// Fails where OpenGL reported an error or left one behind.
    void TearDown() override;
};

/// A frame in memory with its channels by name.
struct Frame3 {
    FloatImage image;

    /// Three channels of a pixel, rows from the top: "" for R, G, B, or a layer's name.
    glm::dvec3 color(int x, int y, const std::string& layer = "") const;
    double depth(int x, int y) const { return double(image.at(x, y, image.channel("Z"))); }
};

/// What the renderer last drew. Layers are read as asked.
Frame3 readBack(const Renderer& renderer, const FrameLayers& layers = {});

/// One frame of a scene with the layers that are asked for; makes the renderer for it.
Frame3 drawOnce(const Scene& scene, const Camera& camera, FrameSettings settings,
                const FrameLayers& layers = {});

/// Settings for measuring: a small picture, no haze, no ambient light, no picture for a screen.
FrameSettings measuringSettings(int width = 64, int height = 48);

/// How many values of the frame are NaN or infinite, Z aside.
int countNotFinite(const Frame3& frame);

}  // namespace ribalta::test
