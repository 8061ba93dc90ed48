// SPDX-License-Identifier: GPL-3.0-or-later
// Work within other work: stages of its own, and the end of the other's.
#include "core/study/job_within.h"

#include <gtest/gtest.h>

#include <atomic>

#include "core/base/error.h"
#include "core/study/step_study.h"

namespace hepatica {
namespace {

TEST(JobWithin, HasStagesOfItsOwnAndEndsWithTheCallers) {
    Job callers;
    callers.begin_stage("outside");
    JobWithin within(callers);
    within.job().begin_stage("inside");
    within.job().advance(0.5);
    EXPECT_EQ(callers.progress().stage, "outside");
    EXPECT_EQ(callers.progress().fraction, 0.0);
    callers.cancel();
    EXPECT_THROW(within.job().advance(0.6), Cancelled);
    EXPECT_THROW(within.job().throw_if_cancelled(), Cancelled);
    EXPECT_THROW(within.job().begin_stage("never"), Cancelled);
}

// Nobody was asked while the body was meshed, which takes most of the time of a large one.
TEST(JobWithin, AsksTheCallerWhileAStudyMeshesItsBody) {
    Job job;
    std::atomic<int> asked = 0;
    job.observe([&](JobEvent event) { asked += event == JobEvent::check ? 1 : 0; });
    study_steps({.tetrahedra = 3000, .frames = 1, .threads = {1}, .tree = {}}, job);
    EXPECT_GT(asked.load(), 20);
}

}  // namespace
}  // namespace hepatica
