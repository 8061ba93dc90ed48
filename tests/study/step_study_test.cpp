// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/step_study.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

TEST(StepStudy, OneAndManyThreadsMakeTheSameStepsWithinTheErrorAskedFor) {
    Job job;
    for (const double tether : {0.0, 20.0}) {
        const auto rows = study_steps({.tetrahedra = 3000,
                                       .frames = 25,
                                       .threads = {1, 2, 4},
                                       .gravity_mm_s2 = tether > 0.0 ? 0.0 : 9810.0,
                                       .tether_pa_per_mm2 = tether,
                                       .tree = {}},
                                      job);
        ASSERT_EQ(rows.size(), 3u);
        for (const StepRow& row : rows) {
            EXPECT_EQ(row.hash, rows[0].hash);
            EXPECT_GT(row.tetrahedra, 1000);
            EXPECT_GT(row.ms, 0.0);
            EXPECT_LE(row.ms, row.longest_ms);
            EXPECT_LE(row.energy_error, 1e-2);
            EXPECT_LE(row.ledger_imbalance, 1e-10);
            EXPECT_GE(row.newton_iterations, 1.0);
            EXPECT_GE(row.iterations, 0.0);
            if (tether > 0.0) {
                EXPECT_EQ(row.newton_iterations, 1.0);  // every frame is one step, taken once
            }
        }
    }
}

}  // namespace
}  // namespace hepatica
