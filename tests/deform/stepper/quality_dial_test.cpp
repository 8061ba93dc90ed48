// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/quality_dial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace hepatica {
namespace {

QualityPoint point(double frame_ms, double error) {
    return {{}, frame_ms, error, "a table"};
}

TEST(QualityDial, KeepsOnlyWhatNothingBeats) {
    const QualityDial dial({point(8, 0.02), point(1, 0.3), point(2, 0.4), point(4, 0.02),
                            point(16, 0.001), point(20, 0.05)});
    ASSERT_EQ(dial.front().size(), 3u);
    EXPECT_EQ(dial.front()[0].frame_ms, 1);
    EXPECT_EQ(dial.front()[1].frame_ms, 4);
    EXPECT_EQ(dial.front()[2].frame_ms, 16);
}

TEST(QualityDial, TurnsFromCheapestToMostAccurate) {
    const QualityDial dial({point(1, 0.3), point(4, 0.02), point(16, 0.001)});
    EXPECT_EQ(dial.at(0.0).frame_ms, 1);
    EXPECT_EQ(dial.at(0.5).frame_ms, 4);
    EXPECT_EQ(dial.at(1.0).frame_ms, 16);
    EXPECT_EQ(dial.at(7.0).frame_ms, 16);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(dial.at(dial.quality_of(i)).frame_ms, dial.front()[i].frame_ms);
}

// A dial is measured one setting after the other, and some miss as much as cheaper ones: the
// cheapest stays where it is, or the slider in the window would jump from end to end and back.
TEST(QualityDial, KeepsTheCheapestAtItsEndWhileItIsMeasured) {
    std::vector<QualityPoint> points;
    for (const auto& [ms, error] : {std::pair{2.0, 0.021}, {4.0, 0.021}, {9.0, 0.014}}) {
        points.push_back(point(ms, error));
        const QualityDial dial(points);
        EXPECT_EQ(dial.quality_of(0), 0.0) << points.size();
        EXPECT_EQ(dial.at(0.0).frame_ms, 2.0);
    }
    EXPECT_EQ(QualityDial(points).quality_of(1), 1.0);
}

TEST(QualityDial, RefusesWhatIsNoMeasurement) {
    EXPECT_THROW(QualityDial({}), InputError);
    EXPECT_THROW(QualityDial({point(0, 0.1)}), InputError);
    EXPECT_THROW(QualityDial({point(1, -0.001)}), InputError);
    const double nan = std::nan("");
    for (const auto& wrong :
         {point(nan, 0.1), point(INFINITY, 0.1), point(1, nan), point(1, INFINITY)})
        EXPECT_THROW(QualityDial({point(2, 0.05), wrong}), InputError);
    EXPECT_NO_THROW(QualityDial({point(1, 0.0)}));
}

}  // namespace
}  // namespace hepatica
