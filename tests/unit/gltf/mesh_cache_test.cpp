// Meshes found decoded by the next start: the same to the bit, and nothing lost where the cache is.
#include <cstring>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "base/file_cache.h"
#include "base/read_file.h"
#include "gltf_file.h"

namespace ribalta::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kLimit = 100'000'000;
const char* const kStage = RIBALTA_SOURCE_DIR "/samples/scenes/stage.glb";

LoadedScene loadStage(const FileCache& cache) {
    LoadOptions options;
    options.cache = &cache;
    return loadGltf(kStage, options);
}

template <typename Value>
bool areEqual(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

void expectEqualMeshes(const LoadedScene& loaded, const LoadedScene& truth) {
    ASSERT_EQ(loaded.scene.meshes.size(), truth.scene.meshes.size());
    EXPECT_EQ(reportText(loaded), reportText(truth));
    for (std::size_t m = 0; m < truth.scene.meshes.size(); ++m) {
        const auto& primitives = loaded.scene.meshes[m].primitives;
        ASSERT_EQ(primitives.size(), truth.scene.meshes[m].primitives.size());
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            const Primitive& expected = truth.scene.meshes[m].primitives[p];
            EXPECT_TRUE(areEqual(primitives[p].positions, expected.positions));
            EXPECT_TRUE(areEqual(primitives[p].normals, expected.normals));
            EXPECT_TRUE(areEqual(primitives[p].tangents, expected.tangents));
            EXPECT_TRUE(areEqual(primitives[p].uv0, expected.uv0));
            EXPECT_TRUE(areEqual(primitives[p].indices, expected.indices));
        }
    }
}

class MeshCacheTest : public ::testing::Test {
  protected:
    // The one file that is kept, and the digits in its name.
    fs::path only() const {
        const std::vector<fs::path> files(fs::directory_iterator(folder_.path()), {});
        EXPECT_EQ(files.size(), 1U);
        return files.at(0);
    }
    std::string key() const { return only().stem().extension().string().substr(1); }

    const TestFolder folder_;
    const FileCache cache_{folder_.path(), kLimit};
    const LoadedScene truth_ = loadGltf(kStage);
};

TEST_F(MeshCacheTest, ASecondLoadDecodesNothingAndIsTheSame) {
    EXPECT_EQ(truth_.meshesFromCache, 0U);
    const LoadedScene first = loadStage(cache_);
    EXPECT_EQ(first.meshesFromCache, 0U);
    expectEqualMeshes(first, truth_);
    const fs::path file = only();
    EXPECT_TRUE(file.filename().string().starts_with("draco.")) << file;
    const std::vector<std::byte> content = readFile(file);

    const LoadedScene second = loadStage(cache_);
    EXPECT_GT(second.meshesFromCache, 0U);
    expectEqualMeshes(second, truth_);
    EXPECT_EQ(readFile(only()), content);
}

TEST_F(MeshCacheTest, ADamagedFileIsDecodedAnewAndReplaced) {
    loadStage(cache_);
    const std::vector<std::byte> whole = readFile(only());
    for (const std::size_t at : {std::size_t(3), whole.size() / 2, whole.size() - 1}) {
        std::vector<std::byte> damaged = whole;
        damaged[at] ^= std::byte(16);
        std::ofstream(only(), std::ios::binary)
            .write(reinterpret_cast<const char*>(damaged.data()), std::streamsize(damaged.size()));
        const LoadedScene loaded = loadStage(cache_);
        EXPECT_EQ(loaded.meshesFromCache, 0U);
        expectEqualMeshes(loaded, truth_);
        EXPECT_EQ(readFile(only()).size(), whole.size());
        EXPECT_GT(loadStage(cache_).meshesFromCache, 0U);
    }
}

// A whole file of this program's, whose content is none that it writes.
TEST_F(MeshCacheTest, ContentThatMakesNoSenseIsDecodedAnew) {
    const std::size_t meshes = [&] {
        loadStage(cache_);
        return loadStage(cache_).meshesFromCache;
    }();
    const std::string digits = key();
    const std::vector<std::byte> content = *cache_.find("draco", digits);

    cache_.keep("draco", digits, std::span(content).first(content.size() - 4));
    const LoadedScene cut = loadStage(cache_);
    EXPECT_EQ(cut.meshesFromCache, 0U);
    expectEqualMeshes(cut, truth_);

    // Behind the mesh's key, size, vertices and number of indices comes the first index.
    std::vector<std::byte> outOfRange = content;
    std::fill_n(outOfRange.begin() + 32, 4, std::byte(0xFF));
    cache_.keep("draco", digits, outOfRange);
    const LoadedScene mended = loadStage(cache_);
    EXPECT_LT(mended.meshesFromCache, meshes);
    EXPECT_GT(mended.meshesFromCache, 0U);
    expectEqualMeshes(mended, truth_);

    cache_.keep("draco", digits, std::vector<std::byte>(4096));
    const LoadedScene zeros = loadStage(cache_);
    EXPECT_EQ(zeros.meshesFromCache, 0U);
    expectEqualMeshes(zeros, truth_);
}

TEST_F(MeshCacheTest, WhatOtherCodeOrOtherDataMadeIsNotFound) {
    loadStage(cache_);
    const std::string other = key() == "0123456789abcdef" ? "0" : "0123456789abcdef";
    fs::rename(only(), folder_ / ("draco." + other + ".cache"));
    EXPECT_EQ(loadStage(cache_).meshesFromCache, 0U);
}

TEST_F(MeshCacheTest, NothingIsKeptOverTheLimit) {
    const FileCache small(folder_.path(), 100'000);
    for (int i = 0; i < 2; ++i) {
        const LoadedScene loaded = loadStage(small);
        EXPECT_EQ(loaded.meshesFromCache, 0U);
        expectEqualMeshes(loaded, truth_);
    }
    std::uint64_t bytes = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path())) {
        bytes += entry.file_size();
    }
    EXPECT_LE(bytes, 100'000U + 64U);
}

TEST_F(MeshCacheTest, SeveralMayLoadAtOnce) {
    std::vector<LoadedScene> loaded(4);
    {
        std::vector<std::jthread> programs;
        for (LoadedScene& each : loaded) {
            programs.emplace_back([&] { each = loadStage(FileCache(folder_.path(), kLimit)); });
        }
    }
    for (const LoadedScene& each : loaded) {
        expectEqualMeshes(each, truth_);
    }
    EXPECT_GT(loadStage(cache_).meshesFromCache, 0U);
}

}  // namespace
}  // namespace ribalta::test
