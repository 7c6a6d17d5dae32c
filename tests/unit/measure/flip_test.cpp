// FLIP against numbers of its authors' own program (version 1.6, C++) for the same 8-bit pictures,
// and against what holds for any pair.
#include "measure/flip.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include <gtest/gtest.h>

#include "make_picture.h"

namespace ribalta::test {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;

using Bytes = std::function<glm::ivec3(int x, int y)>;

RgbPicture fromBytes(const Bytes& bytes) {
    return makePicture(kWidth, kHeight,
                       [&](int x, int y) { return glm::vec3(bytes(x, y)) / 255.0F; });
}

Bytes flat(int r, int g, int b) {
    return [=](int, int) { return glm::ivec3(r, g, b); };
}

glm::ivec3 dot(int x, int y) {
    return x == 20 && y == 15 ? glm::ivec3(255) : glm::ivec3(0);
}

glm::ivec3 bars(int x, int /*y*/) {
    return (x / 5) % 2 == 1 ? glm::ivec3(255, 200, 40) : glm::ivec3(20, 60, 200);
}

glm::ivec3 shiftedBars(int x, int y) {
    return bars(x + 1, y);
}

glm::ivec3 ramp(int x, int y) {
    return {(x * 6) % 256, (y * 8) % 256, (x * y) % 256};
}

glm::ivec3 otherRamp(int x, int y) {
    return {(x * 6 + 9) % 256, (y * 8) % 256, (x * y + (x % 3) * 20) % 256};
}

struct Case {
    const char* name;
    Bytes test;
    Bytes reference;
    double mean;
    double largest;
};

TEST(Flip, AgreesWithItsAuthorsProgram) {
    const Case cases[] = {
        {"white on black", flat(255, 255, 255), flat(0, 0, 0), 0.967397, 0.967388},
        {"green on blue", flat(0, 255, 0), flat(0, 0, 255), 1.000000, 1.000000},
        {"a little lighter", flat(138, 138, 138), flat(128, 128, 128), 0.149012, 0.149010},
        {"a dot", dot, flat(0, 0, 0), 0.011924, 0.864906},
        {"bars moved by a pixel", bars, shiftedBars, 0.523055, 0.980171},
        {"ramps", ramp, otherRamp, 0.182623, 0.311300},
        {"a ramp on grey", ramp, flat(128, 128, 128), 0.776724, 0.978835},
    };
    for (const Case& each : cases) {
        const std::vector<float> errors =
            flipErrors(flipView(fromBytes(each.test)), flipView(fromBytes(each.reference)));
        const double mean =
            std::accumulate(errors.begin(), errors.end(), 0.0) / double(errors.size());
        // It computes in single precision with constants rounded elsewhere.
        EXPECT_NEAR(mean, each.mean, 3e-5) << each.name;
        EXPECT_NEAR(*std::max_element(errors.begin(), errors.end()), each.largest, 5e-5)
            << each.name;
    }
}

TEST(Flip, IsSymmetricWithinRangeAndZeroForEqualPictures) {
    const Bytes pictures[] = {flat(0, 0, 0), flat(255, 255, 255), flat(255, 0, 255), dot, bars,
                              ramp};
    for (const Bytes& a : pictures) {
        for (const Bytes& b : pictures) {
            const FlipView viewA = flipView(fromBytes(a));
            const FlipView viewB = flipView(fromBytes(b));
            const std::vector<float> errors = flipErrors(viewA, viewB);
            EXPECT_EQ(errors, flipErrors(viewB, viewA));
            const auto [low, high] = std::minmax_element(errors.begin(), errors.end());
            EXPECT_GE(*low, 0.0F);
            EXPECT_LE(*high, 1.0F);
            if (&a == &b) {
                EXPECT_EQ(*high, 0.0F);
            }
        }
    }
}

TEST(Flip, AFinePatternIsSeenLessFromAfar) {
    const auto checks = [](int x, int y) { return glm::ivec3((x + y) % 2 == 0 ? 128 : 138); };
    const auto meanAt = [&](double pixelsPerDegree) {
        const std::vector<float> errors =
            flipErrors(flipView(fromBytes(checks), pixelsPerDegree),
                       flipView(fromBytes(flat(133, 133, 133)), pixelsPerDegree));
        return std::accumulate(errors.begin(), errors.end(), 0.0) / double(errors.size());
    };
    EXPECT_LT(meanAt(134.0), 0.5 * meanAt(10.0));
}

TEST(Flip, PicturesSmallerThanItsFiltersAreFine) {
    const std::vector<float> errors = flipErrors(flipView(makeFlat(1, 1, glm::vec3(1.0F))),
                                                 flipView(makeFlat(1, 1, glm::vec3(0.0F))));
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_NEAR(errors[0], 0.967388, 5e-5);
}

}  // namespace
}  // namespace ribalta::test
