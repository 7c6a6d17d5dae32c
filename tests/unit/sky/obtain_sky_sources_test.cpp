// Sources kept as files: those of the same sky, to the bit, and of no other.
#include "sky/obtain_sky_sources.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace ribalta {
namespace {

namespace fs = std::filesystem;

SkyTableSizes smallTables() {
    SkyTableSizes sizes;
    sizes.heights = 4;
    sizes.suns = 6;
    sizes.zenithAngles = 5;
    sizes.azimuths = 4;
    sizes.firstDirections = {3, 2, 3};
    sizes.laterDirections = {3, 2, 3};
    sizes.nodesOfFirst = 3;
    sizes.nodesOfLater = 3;
    return sizes;
}

class SkySourcesFiles : public ::testing::Test {
  protected:
    SkySourcesFiles()
        : files_(fs::path(::testing::TempDir()) / ("sky_sources_" + std::to_string(getpid())),
                 1 << 20) {}
    ~SkySourcesFiles() override { fs::remove_all(files_.folder()); }

    SkySources obtain(const Atmosphere& air, int orders, const SkyTableSizes& sizes) {
        table_.emplace(air, 8, 16);
        return obtainSkySources(*table_, orders, sizes, &files_);
    }
    std::ptrdiff_t count() const {
        return std::distance(fs::directory_iterator(files_.folder()), fs::directory_iterator());
    }

    FileCache files_;
    std::optional<OpticalLengthTable> table_;
};

TEST_F(SkySourcesFiles, AreTheSameToTheBit) {
    const SkySources made = obtain(Atmosphere{}, 4, smallTables());
    EXPECT_EQ(count(), 1);
    const SkySources kept = obtain(Atmosphere{}, 4, smallTables());
    EXPECT_EQ(count(), 1);
    ASSERT_EQ(kept.tables().grids.size(), 3U);
    EXPECT_EQ(kept.tables().grids, made.tables().grids);
    EXPECT_EQ(kept.tables().irradiances, made.tables().irradiances);
    EXPECT_EQ(kept.sum(true), made.sum(true));
    for (const double muS : {-0.05, 0.0, 0.3, 1.0}) {
        EXPECT_EQ(kept.irradiance(2, muS), made.irradiance(2, muS));
    }
}

TEST_F(SkySourcesFiles, AreOfOneSkyOnly) {
    obtain(Atmosphere{}, 3, smallTables());
    std::ptrdiff_t files = 1;
    const auto expectAnother = [&](const Atmosphere& air, int orders, const SkyTableSizes& sizes) {
        obtain(air, orders, sizes);
        EXPECT_EQ(count(), ++files);
    };
    expectAnother(Atmosphere{}, 4, smallTables());
    SkyTableSizes sizes = smallTables();
    sizes.nodesOfLater = 4;
    expectAnother(Atmosphere{}, 3, sizes);
    Atmosphere air;
    air.groundAlbedo.y = 0.2;
    expectAnother(air, 3, smallTables());
    air = {};
    air.mieG = 0.7;
    expectAnother(air, 3, smallTables());
    air = {};
    air.mieExtinctionPerMetre.z *= 1.5;
    expectAnother(air, 3, smallTables());
    // Sources are for a sun of irradiance 1 at one place of the sky.
    air = {};
    air.sunIlluminanceLux *= 2.0;
    obtain(air, 3, smallTables());
    EXPECT_EQ(count(), files);
}

TEST_F(SkySourcesFiles, OfAnotherSizeAreMadeAnew) {
    const SkySources made = obtain(Atmosphere{}, 3, smallTables());
    const std::string file = fs::directory_iterator(files_.folder())->path().filename().string();
    const std::string key = file.substr(4, 16);
    ASSERT_TRUE(files_.find("sky", key)) << file;
    files_.keep("sky", key, std::vector<std::byte>(100));
    EXPECT_EQ(obtain(Atmosphere{}, 3, smallTables()).tables().grids, made.tables().grids);
    EXPECT_GT(files_.find("sky", key)->size(), 100U);
}

}  // namespace
}  // namespace ribalta
