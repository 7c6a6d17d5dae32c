// What is kept in a folder from one run to the next: found whole, or not at all.
#include "base/file_cache.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

namespace ribalta {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> bytesOf(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

class FileCacheTest : public ::testing::Test {
  protected:
    FileCacheTest()
        : folder_(fs::path(::testing::TempDir()) / ("file_cache_" + std::to_string(getpid()))) {
        fs::remove_all(folder_);
    }
    ~FileCacheTest() override { fs::remove_all(folder_); }

    void overwrite(const std::string& content) const {
        std::ofstream(only(), std::ios::binary) << content;
    }
    std::string content() const {
        std::ifstream file(only(), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    fs::path only() const { return folder_ / "sky.ab12.cache"; }

    fs::path folder_;
    FileCache cache_{folder_, 10000};
    const std::vector<std::byte> something_ = bytesOf("something that took long to make");
};

TEST_F(FileCacheTest, FindsWhatWasKept) {
    EXPECT_FALSE(cache_.find("sky", "ab12"));
    cache_.keep("sky", "ab12", something_);
    EXPECT_EQ(cache_.find("sky", "ab12"), something_);
    EXPECT_FALSE(cache_.find("sky", "ab13"));
    EXPECT_FALSE(cache_.find("scene", "ab12"));
    cache_.keep("sky", "ab12", {});
    EXPECT_EQ(cache_.find("sky", "ab12"), std::vector<std::byte>());
}

TEST_F(FileCacheTest, ADamagedFileIsNotFoundAndIsReplaced) {
    cache_.keep("sky", "ab12", something_);
    const std::string whole = content();
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = char(damaged[i] ^ 4);
        overwrite(damaged);
        EXPECT_FALSE(cache_.find("sky", "ab12")) << "byte " << i;
        overwrite(whole.substr(0, i));
        EXPECT_FALSE(cache_.find("sky", "ab12")) << "the first " << i;
    }
    overwrite(whole + "more");
    EXPECT_FALSE(cache_.find("sky", "ab12"));
    cache_.keep("sky", "ab12", something_);
    EXPECT_EQ(cache_.find("sky", "ab12"), something_);
}

TEST_F(FileCacheTest, WhatWasUsedLeastRecentlyMakesRoom) {
    const std::vector<std::byte> large(3000);
    const auto age = [&](const std::string& key, int hours) {
        fs::last_write_time(folder_ / ("sky." + key + ".cache"),
                            fs::file_time_type::clock::now() - std::chrono::hours(hours));
    };
    cache_.keep("sky", "1", large);
    cache_.keep("sky", "2", large);
    cache_.keep("sky", "3", large);
    std::ofstream(folder_ / "notes.txt") << "somebody else's";
    age("1", 3);
    age("2", 2);
    age("3", 1);
    EXPECT_TRUE(cache_.find("sky", "1"));
    cache_.keep("sky", "4", large);
    EXPECT_TRUE(cache_.find("sky", "1"));
    EXPECT_FALSE(cache_.find("sky", "2"));
    EXPECT_TRUE(cache_.find("sky", "3"));
    EXPECT_TRUE(cache_.find("sky", "4"));
    EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
    cache_.keep("sky", "5", std::vector<std::byte>(20000));
    EXPECT_FALSE(cache_.find("sky", "5"));
    EXPECT_TRUE(cache_.find("sky", "4"));
}

TEST_F(FileCacheTest, AFolderThatCannotBeWrittenKeepsNothing) {
    std::ofstream(folder_.string()) << "a file where the folder should be";
    cache_.keep("sky", "ab12", something_);
    EXPECT_FALSE(cache_.find("sky", "ab12"));
}

TEST_F(FileCacheTest, ManyMayWriteTheSame) {
    std::vector<std::thread> writers;
    for (int i = 0; i < 8; ++i) {
        writers.emplace_back([this] {
            for (int k = 0; k < 20; ++k) {
                cache_.keep("sky", "ab12", something_);
                const auto found = cache_.find("sky", "ab12");
                EXPECT_TRUE(!found || *found == something_);
            }
        });
    }
    for (std::thread& writer : writers) {
        writer.join();
    }
    EXPECT_EQ(cache_.find("sky", "ab12"), something_);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

/// A variable of the environment, put back at the end.
class Variable {
  public:
    explicit Variable(const char* name) : name_(name) {
        if (const char* const value = std::getenv(name)) {
            before_ = value;
        }
    }
    ~Variable() {
        if (before_) {
            set(before_->c_str());
        } else {
            unsetenv(name_);
        }
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

    void set(const char* value) const { setenv(name_, value, 1); }

  private:
    const char* name_;
    std::optional<std::string> before_;
};

TEST(UserCacheFolder, FollowsTheEnvironment) {
    const Variable caches("XDG_CACHE_HOME");
    const Variable home("HOME");
    home.set("/home/one");
    caches.set("/somewhere");
    EXPECT_EQ(userCacheFolder(), fs::path("/somewhere/ribalta"));
    caches.set("relative");
    EXPECT_EQ(userCacheFolder(), fs::path("/home/one/.cache/ribalta"));
    caches.set("");
    home.set("");
    EXPECT_EQ(userCacheFolder(), std::nullopt);
}

}  // namespace
}  // namespace ribalta
