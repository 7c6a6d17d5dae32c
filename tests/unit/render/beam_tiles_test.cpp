// Tiles: every pixel that a beam may light finds the beam's lamp in the list of its tile.
#include "render/beam_tiles.h"

#include <array>
#include <set>

#include <gtest/gtest.h>

#include "random_beams.h"
#include "render/lamp_reach.h"

namespace ribalta::test {
namespace {

/// The lamps that the tile of a pixel lists; fails the test where a tile or a lamp stands twice or
/// outside the picture.
class TileLists {
  public:
    TileLists(const BeamTiles& tiles, int width, int height, int lamps) {
        const int across = (width + gpu::kTileSide - 1) / gpu::kTileSide;
        const int down = (height + gpu::kTileSide - 1) / gpu::kTileSide;
        lists_.assign(std::size_t(across) * std::size_t(down), {});
        across_ = across;
        std::set<std::pair<int, int>> places;
        for (const gpu::BeamSquare& tile : tiles.tiles) {
            const glm::ivec4 place = tile.place;
            EXPECT_TRUE(places.emplace(place.x, place.y).second) << "a tile twice";
            EXPECT_GT(place.w, 0) << "an empty tile";
            if (place.x < 0 || place.y < 0 || place.x >= across || place.y >= down) {
                ADD_FAILURE() << "a tile outside the picture: " << place.x << ", " << place.y;
                continue;
            }
            for (int i = place.z; i < place.z + place.w; ++i) {
                const int lamp = tiles.lamps.at(std::size_t(i));
                EXPECT_GE(lamp, 0);
                EXPECT_LT(lamp, lamps);
                EXPECT_TRUE(list(place.x, place.y).insert(lamp).second) << "a lamp twice";
            }
        }
    }

    std::set<int>& list(int x, int y) {
        return lists_[std::size_t(y) * std::size_t(across_) + std::size_t(x)];
    }
    bool holds(const glm::dvec2& pixel, int lamp) {
        return list(int(pixel.x) / gpu::kTileSide, int(pixel.y) / gpu::kTileSide).count(lamp) > 0;
    }

  private:
    int across_ = 0;
    std::vector<std::set<int>> lists_;
};

TEST(BeamTiles, EveryPointOfABeamFindsItsLamp) {
    RandomBeams random(11);
    int shown = 0;
    for (int i = 0; i < 1500; ++i) {
        const int width = int(random.between(1.0, 200.0));
        const int height = int(random.between(1.0, 200.0));
        const std::array<SpotLight, 3> lamps = {random.lamp(), random.lamp(), random.lamp()};
        const Camera camera = random.camera(lamps[0]);
        std::vector<std::vector<glm::dvec2>> outlines;
        outlines.reserve(lamps.size());
        for (const SpotLight& lamp : lamps) {
            outlines.push_back(beamOutline(lamp, camera, width, height));
        }
        TileLists lists(makeBeamTiles(outlines, width, height), width, height, 3);
        for (int l = 0; l < 3; ++l) {
            for (int p = 0; p < 40; ++p) {
                const glm::dvec3 point = random.pointInBeam(lamps[std::size_t(l)], 500.0);
                const std::optional<glm::dvec2> pixel = project(camera, width, height, point);
                if (!pixel || pixel->x < 0.0 || pixel->y < 0.0 || pixel->x >= width ||
                    pixel->y >= height) {
                    continue;
                }
                ++shown;
                ASSERT_TRUE(lists.holds(*pixel, l))
                    << "case " << i << ", lamp " << l << ", pixel " << pixel->x << ", " << pixel->y;
            }
        }
    }
    EXPECT_GT(shown, 20000);
}

TEST(BeamTiles, ASmallOutlineTakesOneTile) {
    const BeamTiles tiles = makeBeamTiles({{{20, 36}, {24, 36}, {22, 40}}}, 64, 64);
    ASSERT_EQ(tiles.tiles.size(), 1U);
    EXPECT_EQ(tiles.tiles[0].place, glm::ivec4(1, 2, 0, 1));
    EXPECT_EQ(tiles.lamps, std::vector<int>{0});
}

TEST(BeamTiles, AnOutlineThinnerThanAPixelIsNotLost) {
    const BeamTiles tiles =
        makeBeamTiles({{{0.0, 8.2}, {64.0, 8.2}, {64.0, 8.2001}, {0.0, 8.2001}}}, 64, 16);
    EXPECT_EQ(tiles.tiles.size(), 4U);
}

TEST(BeamTiles, OutlinesBesideThePictureAndNoneGiveNoTiles) {
    EXPECT_TRUE(makeBeamTiles({{{100, 10}, {120, 10}, {110, 20}}}, 64, 64).tiles.empty());
    EXPECT_TRUE(makeBeamTiles({{{10, -30}, {20, -30}, {15, -20}}}, 64, 64).tiles.empty());
    EXPECT_TRUE(makeBeamTiles({{}, {}}, 64, 64).tiles.empty());
    EXPECT_TRUE(makeBeamTiles({}, 64, 64).tiles.empty());
}

TEST(BeamTiles, ListsFollowOneAnotherInTheLampsOrder) {
    const std::vector<glm::dvec2> everywhere = {{-10, -10}, {100, -10}, {100, 100}, {-10, 100}};
    const BeamTiles tiles = makeBeamTiles({everywhere, {}, everywhere}, 32, 16);
    ASSERT_EQ(tiles.tiles.size(), 2U);
    EXPECT_EQ(tiles.tiles[0].place, glm::ivec4(0, 0, 0, 2));
    EXPECT_EQ(tiles.tiles[1].place, glm::ivec4(1, 0, 2, 2));
    EXPECT_EQ(tiles.lamps, (std::vector<int>{0, 2, 0, 2}));
}

}  // namespace
}  // namespace ribalta::test
