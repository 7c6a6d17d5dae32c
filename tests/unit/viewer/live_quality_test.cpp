// Coarse pictures keep the time on machines of any speed, and do not flicker between sizes.
#include "viewer/live_quality.h"

#include <gtest/gtest.h>

namespace ribalta {
namespace {

FrameSettings still() {
    FrameSettings settings;
    settings.width = 1280;
    settings.height = 720;
    settings.beams.planes = 24;
    return settings;
}

// A machine that takes so long for the whole window; `share` of it however few the pixels.
double timeOf(const LiveQuality& quality, double wholeMs, double share) {
    const double scale = quality.scale();
    return wholeMs * (share + (1.0 - share) * scale * scale);
}

TEST(LiveQuality, KeepsTheTimeWhereTheMachineCan) {
    for (const double share : {0.0, 0.02}) {
        for (const double wholeMs : {0.5, 5.0, 12.0, 20.0, 60.0, 200.0, 400.0}) {
            LiveQuality quality;
            for (int frame = 0; frame < 20; ++frame) {
                quality.took(timeOf(quality, wholeMs, share));
            }
            EXPECT_LE(timeOf(quality, wholeMs, share), LiveQuality::kFrameMs) << wholeMs;
            if (wholeMs < 10.0) {
                EXPECT_EQ(quality.scale(), 1.0) << wholeMs;
            }
        }
    }
}

TEST(LiveQuality, SettlesOnOneSize) {
    for (double wholeMs = 1.0; wholeMs < 1000.0; wholeMs *= 1.07) {
        LiveQuality quality;
        for (int frame = 0; frame < 20; ++frame) {
            quality.took(timeOf(quality, wholeMs, 0.01));
        }
        const double settled = quality.scale();
        for (int frame = 0; frame < 20; ++frame) {
            quality.took(timeOf(quality, wholeMs, 0.01));
            EXPECT_EQ(quality.scale(), settled) << wholeMs;
        }
    }
}

TEST(LiveQuality, IsNeverCoarserThanItsLimit) {
    LiveQuality quality;
    quality.took(1e6);
    EXPECT_EQ(quality.scale(), LiveQuality::kCoarsest);
    const FrameSettings coarse = quality.coarsened(still());
    EXPECT_EQ(coarse.width, 160);
    EXPECT_EQ(coarse.height, 90);
    EXPECT_EQ(coarse.beams.planes, LiveQuality::kSheets);
    FrameSettings tiny = still();
    tiny.width = tiny.height = 1;
    tiny.beams.planes = 3;
    EXPECT_EQ(quality.coarsened(tiny).width, 1);
    EXPECT_EQ(quality.coarsened(tiny).beams.planes, 3);
    quality.took(0.0);  // a clock that stood still
    EXPECT_EQ(quality.scale(), LiveQuality::kCoarsest);
}

}  // namespace
}  // namespace ribalta
