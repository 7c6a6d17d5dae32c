// Lit stretches of functions whose edges are known.
#include "reference/lit_stretches.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace ribalta {
namespace {

std::vector<double> evenProbes(int count) {
    std::vector<double> probes;
    for (int i = 0; i < count; ++i) {
        probes.push_back(double(i) / (count - 1));
    }
    return probes;
}

TEST(LitStretches, MeetTheEdgesOfTheDark) {
    const auto lit = [](double x) { return (x > 0.123456789 && x < 0.4) || x > 0.777; };
    const std::vector<Interval> stretches = litStretches(lit, evenProbes(20));
    ASSERT_EQ(stretches.size(), 2U);
    EXPECT_NEAR(stretches[0].first, 0.123456789, 1e-12);
    EXPECT_NEAR(stretches[0].last, 0.4, 1e-12);
    EXPECT_NEAR(stretches[1].first, 0.777, 1e-12);
    EXPECT_EQ(stretches[1].last, 1.0);
}

TEST(LitStretches, AllOrNothing) {
    const std::vector<Interval> all = litStretches([](double) { return true; }, evenProbes(2));
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].first, 0.0);
    EXPECT_EQ(all[0].last, 1.0);
    EXPECT_TRUE(litStretches([](double) { return false; }, evenProbes(9)).empty());
}

TEST(LitStretches, FollowManyStripes) {
    const auto lit = [](double x) { return int(std::floor(81.0 * x)) % 2 == 1; };
    const std::vector<Interval> stretches = litStretches(lit, evenProbes(128));
    ASSERT_EQ(stretches.size(), 41U - 1U + (lit(1.0) ? 1U : 0U));
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_NEAR(stretches[i].first, double(2 * i + 1) / 81.0, 1e-12);
        EXPECT_NEAR(stretches[i].last, double(2 * i + 2) / 81.0, 1e-12);
    }
}

}  // namespace
}  // namespace ribalta
