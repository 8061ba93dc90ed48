// SPDX-License-Identifier: GPL-3.0-or-later
// The benchmark of the haptic loop: it feels a full patch while the play runs. What it takes is a
// benchmark, not tested.
#include "core/study/haptic_study.h"

#include <gtest/gtest.h>

#include "core/haptics/local_model.h"

namespace hepatica {
namespace {

TEST(HapticStudy, FeelsAFullPatchWhileThePlayRuns) {
    Job job;
    HapticStudyOptions options;
    options.seconds = 0.5;
    const HapticStudy study = study_haptics(nullptr, options, job);
    EXPECT_EQ(job.stage_times().size(), 2u);
    EXPECT_GT(study.periods, 10);
    EXPECT_GE(study.contacts_most, most_local_contacts);
    EXPECT_GT(study.full, 0.5);
    EXPECT_GE(study.in_time, 0.0);
    EXPECT_LE(study.in_time, 1.0);
    EXPECT_LE(study.median_us, study.p999_us);
    EXPECT_LE(study.p999_us, study.longest_us);
    EXPECT_GT(study.steps, 1);
    EXPECT_GT(study.tetrahedra, 1000);
}

}  // namespace
}  // namespace hepatica
