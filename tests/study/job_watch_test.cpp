// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/job_watch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace hepatica {
namespace {

void wait_ms(int ms) {
    std::this_thread::sleep_for(std::chrono::milliseconds(ms));
}

TEST(JobWatch, FindsTheLongestSilenceOfEachStage) {
    Job job;
    const JobWatch watch(job);
    job.begin_stage("first");
    wait_ms(20);
    job.throw_if_cancelled();
    wait_ms(60);
    job.throw_if_cancelled();
    wait_ms(5);
    job.begin_stage("second");
    wait_ms(10);
    job.advance(0.5);
    const auto stages = watch.stages();
    ASSERT_EQ(stages.size(), 2u);
    EXPECT_EQ(stages[0].name, "first");
    EXPECT_GE(stages[0].longest_check.wall_s, 0.060);
    EXPECT_GE(stages[0].longest_progress.wall_s, 0.080);  // none came until the next stage
    EXPECT_GE(stages[0].whole.wall_s, 0.085);
    // Waiting costs no processor time, however busy the machine is.
    EXPECT_LT(stages[0].longest_check.cpu_s, 0.050);
    EXPECT_GE(stages[1].longest_progress.wall_s, 0.010);
    EXPECT_EQ(stages[1].reports, 2u);
}

}  // namespace
}  // namespace hepatica
