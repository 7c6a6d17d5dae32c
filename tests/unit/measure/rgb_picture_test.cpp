// What is refused before anything is measured.
#include "measure/rgb_picture.h"

#include <limits>

#include <gtest/gtest.h>

#include "make_picture.h"
#include "support/expect_error.h"

namespace ribalta::test {
namespace {

TEST(PickLayer, FindsChannelsByName) {
    const FloatImage image{1,
                           2,
                           {"Z", "beams.B", "beams.G", "beams.R", "B", "G", "R"},
                           {9, 3, 2, 1, 6, 5, 4, 9, 13, 12, 11, 16, 15, 14}};
    const RgbPicture beams = pickLayer(image, "beams", {"a.exr", ""});
    EXPECT_EQ(beams.at(0, 0), glm::vec3(1, 2, 3));
    EXPECT_EQ(beams.at(0, 1), glm::vec3(11, 12, 13));
    EXPECT_EQ(pickLayer(image, "", {"a.exr", ""}).at(0, 1), glm::vec3(14, 15, 16));
    expectError(ErrorKind::kBadInput, {"a.exr", "no layer 'normal'", "beams"}, [&] {
        pickLayer(image, "normal", {"a.exr", ""});
    });
}

TEST(PickLayer, SpreadsGreyAndRefusesWhatHasNoColour) {
    EXPECT_EQ(pickLayer({1, 1, {"Y"}, {7}, {}}, "", {"a.png", ""}).at(0, 0), glm::vec3(7));
    expectError(ErrorKind::kBadInput, {"a.exr", "no channels R, G, B", "Z"}, [&] {
        pickLayer({1, 1, {"Z"}, {7}, {}}, "", {"a.exr", ""});
    });
}

TEST(RefuseNonFinite, CountsPixelsAndNamesTheFirst) {
    RgbPicture picture = makeFlat(4, 3, glm::vec3(1.0F));
    EXPECT_NO_THROW(refuseNonFinite(picture, {"a.exr", ""}));
    picture.pixels[6].y = std::numeric_limits<float>::quiet_NaN();
    picture.pixels[11] = glm::vec3(std::numeric_limits<float>::infinity());
    expectError(ErrorKind::kBadInput, {"a.exr", "2 of 12 pixels", "at 2,1"}, [&] {
        refuseNonFinite(picture, {"a.exr", ""});
    });
}

TEST(RefuseOtherSize, NamesBoth) {
    expectError(ErrorKind::kBadInput, {"a.png", "4x3", "3x4"}, [] {
        refuseOtherSize(makeFlat(4, 3, glm::vec3(0.0F)), makeFlat(3, 4, glm::vec3(0.0F)),
                        {"a.png", ""});
    });
}

}  // namespace
}  // namespace ribalta::test
