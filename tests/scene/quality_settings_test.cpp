// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/quality_settings.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace hepatica {
namespace {

TEST(QualitySettings, CostMoreAndMissLessAsTheDialTurns) {
    const QualityPoint* last = &quality_point(0.0);
    int changes = 0;
    for (int i = 1; i <= 100; ++i) {
        const QualityPoint& now = quality_point(0.01 * i);
        if (&now == last) continue;
        ++changes;
        EXPECT_GT(now.frame_ms, last->frame_ms);
        EXPECT_LT(now.error_relative, last->error_relative);
        last = &now;
    }
    EXPECT_GE(changes, 1);
}

TEST(QualitySettings, SayWhatTheErrorWasMeasuredAgainst) {
    for (const double quality : {0.0, 0.5, 1.0}) {
        EXPECT_GT(quality_point(quality).error_relative, 0.0);
        EXPECT_FALSE(quality_point(quality).reference.empty());
    }
}

TEST(QualitySettings, RefuseWhatIsNotOnTheDial) {
    for (const double quality : {-0.1, 1.1})
        EXPECT_THROW(stepper_options(quality), InputError) << quality;
}

}  // namespace
}  // namespace hepatica
