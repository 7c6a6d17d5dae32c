// The four faults that beams made of planes through the whole view are known for (Pessoa 2007),
// each on a small scene of its own as a number that suits it: what `planes` has of it, and what is
// left of it by default. Held against the double-precision reference.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "gltf/load_gltf.h"
#include "gpu/gpu_test.h"
#include "optics/shader_lib.h"
#include "reference/reference_picture.h"

namespace ribalta::test {
namespace {

/// The thesis's pictures have 40 to 55 planes.
constexpr int kThesisPlanes = 40;

class ThesisFaults : public GpuTest {
  protected:
    void load(const std::string& name) {
        scene_ = loadGltf(RIBALTA_SOURCE_DIR "/samples/scenes/faults/" + name + ".glb").scene;
        ASSERT_EQ(scene_.cameras.size(), 1U);
    }
    /// Values of one channel, rows from the top: all lamps are white.
    struct Channel {
        int width = 0;
        int height = 0;
        std::vector<double> values;

        double at(int x, int y) const {
            return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
        }
    };
    Channel draw(const FrameSettings& settings) const {
        FrameLayers layers;
        layers.beams = true;
        const Frame3 frame = drawOnce(scene_, scene_.cameras[0], settings, layers);
        Channel channel{settings.width, settings.height, {}};
        for (int y = 0; y < settings.height; ++y) {
            for (int x = 0; x < settings.width; ++x) {
                channel.values.push_back(frame.color(x, y, "beams").y);
            }
        }
        return channel;
    }
    FrameSettings planes() const {
        FrameSettings settings = settings_;
        settings.beams.method = BeamMethod::kPlanes;
        settings.beams.planes = kThesisPlanes;
        return settings;
    }
    ReferencePicture reference(double relativeError = 1e-4) const {
        ReferenceSettings settings;
        settings.camera = scene_.cameras[0];
        settings.width = settings_.width;
        settings.height = settings_.height;
        settings.haze = settings_.haze;
        settings.relativeError = relativeError;
        return drawReference(scene_, settings);
    }
    static Channel beamsOf(const ReferencePicture& picture) {
        Channel channel{picture.width, picture.height, {}};
        for (const glm::dvec3& pixel : picture.beams) {
            channel.values.push_back(pixel.y);
        }
        return channel;
    }
    /// Draws the fault's number of both methods; `planes` must have `times` as much of it.
    static void compare(const char* fault, double planes, double byDefault, double times) {
        std::printf("%s: planes %.4g, default %.4g: %.0f times less\n", fault, planes, byDefault,
                    planes / byDefault);
        EXPECT_GE(planes, times * byDefault);
    }
    static FrameSettings smallPicture() {
        FrameSettings settings;
        settings.width = 160;
        settings.height = 120;
        return settings;
    }

    Scene scene_;
    FrameSettings settings_ = smallPicture();
};

/// How much the error of a picture goes up and down from row to row, as a share of the light there:
/// an even error counts nothing, a step counts its height.
double steps(const auto& drawn, const auto& reference, const std::vector<double>& depths) {
    double sum = 0.0;
    double light = 0.0;
    for (int y = 0; y + 1 < drawn.height; ++y) {
        for (int x = 0; x < drawn.width; ++x) {
            const std::size_t pixel = std::size_t(y) * std::size_t(drawn.width) + std::size_t(x);
            if (!std::isfinite(depths[pixel]) ||
                !std::isfinite(depths[pixel + std::size_t(drawn.width)])) {
                continue;
            }
            const double above = drawn.at(x, y) - reference.at(x, y);
            sum += std::abs(drawn.at(x, y + 1) - reference.at(x, y + 1) - above);
            light += reference.at(x, y);
        }
    }
    return sum / light;
}

TEST_F(ThesisFaults, StripesWhereSheetsMeetGeometry) {
    load("stripes");
    const ReferencePicture exact = reference();
    const Channel light = beamsOf(exact);
    const double byPlanes = steps(draw(planes()), light, exact.depths);
    const double byDefault = steps(draw(settings_), light, exact.depths);
    EXPECT_GT(byPlanes, 0.004);
    compare("stripes (steps from row to row on the floor, share of its light)", byPlanes, byDefault,
            5.0);
}

/// Root of the mean square error as a share of the light's, over the right half of the picture: the
/// left one has the lamp in it, whose brightness would hide the rest.
double relativeRmse(const auto& drawn, const auto& reference) {
    double off = 0.0;
    double light = 0.0;
    for (int y = 0; y < drawn.height; ++y) {
        for (int x = drawn.width / 2; x < drawn.width; ++x) {
            off += std::pow(drawn.at(x, y) - reference.at(x, y), 2);
            light += std::pow(reference.at(x, y), 2);
        }
    }
    return std::sqrt(off / light);
}

TEST_F(ThesisFaults, AliasingOfFineLightMaps) {
    load("aliasing");
    const Channel light = beamsOf(reference());
    const double byPlanes = relativeRmse(draw(planes()), light);
    const double byDefault = relativeRmse(draw(settings_), light);
    EXPECT_GT(byPlanes, 0.1);
    compare("aliasing (relative RMSE away from the lamp)", byPlanes, byDefault, 5.0);
}

/// The largest jump of the error between neighbours in a column, in code values of 8 bits.
double largestJump(const auto& drawn, const auto& reference, double fullScale) {
    double largest = 0.0;
    for (int y = 0; y + 1 < drawn.height; ++y) {
        for (int x = 0; x < drawn.width; ++x) {
            // Brighter than the screen shows either way.
            if (std::max(reference.at(x, y), reference.at(x, y + 1)) > 0.9 * fullScale) {
                continue;
            }
            const double above = drawn.at(x, y) - reference.at(x, y);
            const double below = drawn.at(x, y + 1) - reference.at(x, y + 1);
            largest = std::max(largest, std::abs(below - above) / fullScale * 255.0);
        }
    }
    return largest;
}

TEST_F(ThesisFaults, QuantisationOfManyThinSheets) {
    load("quantisation");
    settings_.ev100 = 3.0;
    const double fullScale = 1.0 / shader::exposureFromEv100(*settings_.ev100);
    const Channel light = beamsOf(reference());
    FrameSettings eightBit = planes();
    eightBit.beams.planes = 400;
    FrameSettings floats = eightBit;
    eightBit.beams.eightBitBlending = true;
    const double byPlanes = largestJump(draw(eightBit), light, fullScale);
    const double inFloats = largestJump(draw(floats), light, fullScale);
    const double byDefault = largestJump(draw(settings_), light, fullScale);
    std::printf("quantisation: the same planes added in floats %.4g\n", inFloats);
    EXPECT_GT(byPlanes, 10.0);
    EXPECT_GT(byPlanes, 5.0 * inFloats) << "it is the eight bits, not the planes";
    compare("quantisation (largest jump, code values)", byPlanes, byDefault, 5.0);
}

/// Each of the five beams lies in a band of rows of its own; its light column by column against
/// what it should be, root mean square. 1: it comes and goes altogether.
double unevenness(const auto& drawn, const auto& reference) {
    constexpr int kBeams = 5;
    double sum = 0.0;
    int count = 0;
    for (int beam = 0; beam < kBeams; ++beam) {
        for (int x = 0; x < drawn.width; ++x) {
            double is = 0.0;
            double should = 0.0;
            for (int y = beam * drawn.height / kBeams; y < (beam + 1) * drawn.height / kBeams;
                 ++y) {
                is += drawn.at(x, y);
                should += reference.at(x, y);
            }
            if (should > 0.0) {
                sum += std::pow(is / should - 1.0, 2);
                ++count;
            }
        }
    }
    return std::sqrt(sum / count);
}

TEST_F(ThesisFaults, StreaksWhereLightRunsAlongThePlanes) {
    load("streaks");
    settings_.width = 320;
    settings_.height = 240;
    const Channel light = beamsOf(reference());
    const double byPlanes = unevenness(draw(planes()), light);
    const double byDefault = unevenness(draw(settings_), light);
    EXPECT_GT(byPlanes, 0.5);
    compare("streaks (how a beam's light comes and goes along it, RMS)", byPlanes, byDefault, 5.0);
}

}  // namespace
}  // namespace ribalta::test
