// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/region_study.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

TEST(RegionStudy, ATwigInTissueIsComputedAloneAndMovesAsInTheWhole) {
    RegionStudyOptions options;
    options.frames = 12;
    options.frames_after = 12;
    options.generations = {4};
    options.tether_pa_per_mm2 = 5000.0;
    Job job;
    const auto rows = study_region(options, job);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_GT(rows[0].tetrahedra, 5000);
    EXPECT_GT(rows[0].live_tetrahedra, 0);
    EXPECT_LT(rows[0].live_tetrahedra, rows[0].tetrahedra / 2);
    EXPECT_LT(rows[0].difference_mm, 0.01);
    EXPECT_GT(rows[0].rms_difference, 0.0);
    EXPECT_LT(rows[0].rms_difference, 0.02);
}

}  // namespace
}  // namespace hepatica
