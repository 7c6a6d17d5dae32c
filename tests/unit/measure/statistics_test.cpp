// Medians, quartiles, Pareto fronts and times to an error, against values found by hand.
#include "measure/statistics.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "measure/pareto.h"

namespace ribalta::test {
namespace {

TEST(Statistics, MedianOfFewValues) {
    EXPECT_EQ(median({}), 0.0);
    EXPECT_EQ(median({7.0}), 7.0);
    EXPECT_EQ(median({9.0, 1.0, 5.0}), 5.0);
    EXPECT_EQ(median({4.0, 1.0, 2.0, 3.0}), 2.5);
}

TEST(Statistics, QuantilesLieBetweenNeighbours) {
    EXPECT_EQ(quantile({10.0, 20.0, 30.0, 40.0, 50.0}, 0.25), 20.0);
    EXPECT_EQ(quantile({0.0, 10.0}, 0.3), 3.0);
    EXPECT_EQ(quantile({1.0, 2.0}, 1.0), 2.0);
    EXPECT_EQ(quantile({1.0, 2.0}, 0.0), 1.0);
}

TEST(Statistics, SpreadIsNotMovedByOneSlowFrame) {
    const Spread spread = spreadOf({10.0, 10.5, 11.0, 11.5, 1000.0});
    EXPECT_EQ(spread.median, 11.0);
    EXPECT_EQ(spread.iqr, 1.0);
    EXPECT_EQ(spreadOf({5.0}).iqr, 0.0);
}

TEST(Pareto, KeepsWhatNothingBeats) {
    const std::vector<Cost> points = {{1.0, 9.0}, {2.0, 3.0},  {2.5, 3.0}, {3.0, 4.0},
                                      {4.0, 1.0}, {2.0, 10.0}, {9.0, 1.0}};
    EXPECT_EQ(paretoFront(points), (std::vector<std::size_t>{0, 1, 4}));
}

TEST(Pareto, EqualPointsAreBothOnIt) {
    EXPECT_EQ(paretoFront({{2.0, 1.0}, {1.0, 5.0}, {1.0, 5.0}}),
              (std::vector<std::size_t>{1, 2, 0}));
}

TEST(Pareto, WhatIsNoNumberIsLeftOut) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(paretoFront({{nan, 0.0}, {1.0, nan}, {2.0, 2.0}}), (std::vector<std::size_t>{2}));
    EXPECT_TRUE(paretoFront({}).empty());
}

TEST(TimeToError, IsAStraightLineInLogLog) {
    // Error 8 / time: every time is its inverse.
    const std::vector<Cost> points = {{1.0, 8.0}, {4.0, 2.0}, {16.0, 0.5}};
    for (const double error : {8.0, 5.0, 2.0, 1.0, 0.5}) {
        EXPECT_NEAR(timeToError(points, error).value(), 8.0 / error, 1e-12) << error;
    }
    EXPECT_FALSE(timeToError(points, 0.4).has_value());
    EXPECT_EQ(timeToError(points, 100.0).value(), 1.0);
}

TEST(TimeToError, APointThatIsWorseAndSlowerChangesNothing) {
    const std::vector<Cost> points = {{1.0, 8.0}, {2.0, 9.0}, {4.0, 2.0}, {5.0, 7.0}};
    EXPECT_NEAR(timeToError(points, 4.0).value(), 2.0, 1e-12);
}

TEST(TimeToError, NoErrorAtAll) {
    EXPECT_EQ(timeToError({{1.0, 3.0}, {7.0, 0.0}}, 1.0).value(), 7.0);
    EXPECT_EQ(timeToError({{2.0, 0.0}}, 0.0).value(), 2.0);
    EXPECT_FALSE(timeToError({}, 1.0).has_value());
}

}  // namespace
}  // namespace ribalta::test
