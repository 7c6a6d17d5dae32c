#include "base/parallel_for.h"

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace ribalta {
namespace {

TEST(ParallelFor, CallsEachIndexOnce) {
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
        std::vector<std::atomic<int>> calls(count);
        parallelFor(count, [&](std::size_t i) { ++calls[i]; });
        for (const auto& number : calls) {
            EXPECT_EQ(number, 1);
        }
    }
}

TEST(ParallelFor, RethrowsAndHandsOutNoMoreWork) {
    std::atomic<std::size_t> calls = 0;
    constexpr std::size_t kMany = 10'000'000;
    try {
        parallelFor(kMany, [&](std::size_t i) {
            ++calls;
            if (i == 3) {
                throw std::runtime_error("three");
            }
        });
        FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "three");
    }
    EXPECT_LT(calls, kMany);
}

TEST(ParallelFor, EveryCallMayThrow) {
    EXPECT_THROW(
        parallelFor(100, [](std::size_t i) { throw std::out_of_range(std::to_string(i)); }),
        std::out_of_range);
}

TEST(ParallelFor, MayBeNested) {
    std::atomic<int> calls = 0;
    parallelFor(10, [&](std::size_t) { parallelFor(10, [&](std::size_t) { ++calls; }); });
    EXPECT_EQ(calls, 100);
}

}  // namespace
}  // namespace ribalta
