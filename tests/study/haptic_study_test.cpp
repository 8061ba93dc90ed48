// SPDX-License-Identifier: GPL-3.0-or-later
// The benchmark of the haptic loop: it feels a full patch while the play runs. What it takes is a
// benchmark, not tested.
#include "core/study/haptic_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "core/base/error.h"
#include "core/haptics/local_model.h"
#include "tests/session/small_patient.h"

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

// Forceps without a direction are refused. Their error had no words.
TEST(HapticStudy, SaysWhyTheForcepsFindNoPlace) {
    const auto bent = std::make_shared<PatientCase>(*test::small_patient());
    auto& longest = *std::ranges::max_element(
        bent->tree.segments, {}, [](const auto& segment) { return segment.points_mm.size(); });
    const std::size_t middle = longest.points_mm.size() / 2;
    longest.points_mm[middle] = longest.points_mm[middle - 1];
    Job job;
    try {
        study_haptics(bent, {}, job);
        FAIL() << "forceps without a direction were taken";
    } catch (const InputError& error) {
        EXPECT_FALSE(error.problem().empty());
        EXPECT_EQ(error.place(), "the forceps of the benchmark");
        EXPECT_FALSE(error.remedy().empty());
    }
}

}  // namespace
}  // namespace hepatica
