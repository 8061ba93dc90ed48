// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/quality_dial.h"

#include <gtest/gtest.h>

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

TEST(QualityDial, RefusesWhatIsNoMeasurement) {
    EXPECT_THROW(QualityDial({}), InputError);
    EXPECT_THROW(QualityDial({point(0, 0.1)}), InputError);
    EXPECT_THROW(QualityDial({point(1, -0.001)}), InputError);
    EXPECT_NO_THROW(QualityDial({point(1, 0.0)}));
}

}  // namespace
}  // namespace hepatica
