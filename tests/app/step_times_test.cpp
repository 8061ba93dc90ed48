// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/step_times.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

SessionStep step_of(double ms, bool asleep = false) {
    SessionStep step;
    step.step_ms = ms;
    step.deform.asleep = asleep;
    return step;
}

TEST(StepTimes, FramesInTimeTakeAtMostASixtiethOfASecond) {
    StepTimes times;
    EXPECT_TRUE(times.frames_in_time().is_null());
    times.add(step_of(0.1, true));
    EXPECT_TRUE(times.frames_in_time().is_null());
    for (const double ms : {1.0, 16.6, 1000.0 / 60.0, 16.7}) times.add(step_of(ms));
    EXPECT_DOUBLE_EQ(times.frames_in_time().get<double>(), 0.75);
    times.add(step_of(0.1, true));
    EXPECT_DOUBLE_EQ(times.frames_in_time().get<double>(), 0.75);
    EXPECT_EQ(times.steps(), 6u);
}

}  // namespace
}  // namespace hepatica
