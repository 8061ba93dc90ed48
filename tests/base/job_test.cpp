// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/job.h"

#include <gtest/gtest.h>

#include <thread>

#include "core/base/error.h"
#include "core/base/stop.h"

namespace hepatica {
namespace {

TEST(Job, ReportsStagesAndTheirTimes) {
    Job job;
    job.expect_stages(2);
    EXPECT_EQ(job.progress().stage_number, 0);
    job.begin_stage("read");
    job.advance(0.5);
    EXPECT_EQ(job.progress().stage, "read");
    EXPECT_DOUBLE_EQ(job.progress().fraction, 0.5);
    job.begin_stage("thin");
    EXPECT_EQ(job.progress().stage_number, 2);
    EXPECT_EQ(job.progress().stage_count, 2);
    EXPECT_DOUBLE_EQ(job.progress().fraction, 0.0);
    const auto times = job.stage_times();
    ASSERT_EQ(times.size(), 2u);
    EXPECT_EQ(times[0].name, "read");
    EXPECT_GE(times[0].seconds, 0.0);
}

// What is called announces only its own stages, what calls it all of them.
TEST(Job, KeepsTheCountOfTheOutermostAnnouncement) {
    Job job;
    job.expect_stages(3);
    job.begin_stage("read");
    job.expect_stages(1);
    job.begin_stage("thin");
    job.begin_stage("write");
    EXPECT_EQ(job.progress().stage_count, 3);
    job.expect_stages(2);  // all that was announced has begun: another piece of work
    EXPECT_EQ(job.progress().stage_count, 5);
}

// A step reports from 0 to 1 and knows nothing of those before and after it.
TEST(JobPart, TurnsTheProgressOfAStepIntoAShareOfTheStage) {
    Job job;
    job.begin_stage("smooth");
    const auto said = [&] { return job.progress().fraction; };
    {
        const JobPart first(job, 0.0, 0.4);
        job.advance(0.5);
        EXPECT_DOUBLE_EQ(said(), 0.2);
        job.advance(1.0);
        EXPECT_DOUBLE_EQ(said(), 0.4);
        job.advance(7.0);
        EXPECT_DOUBLE_EQ(said(), 0.4);
    }
    {
        const JobPart second(job, 0.5, 1.0);
        EXPECT_DOUBLE_EQ(said(), 0.5) << "its beginning is told at once";
        {
            const JobPart inner(job, 0.0, 0.5);
            job.advance(0.5);
            EXPECT_DOUBLE_EQ(said(), 0.625);
        }
        job.advance(0.75);
        EXPECT_DOUBLE_EQ(said(), 0.875);
    }
    job.advance(1.0);
    EXPECT_DOUBLE_EQ(said(), 1.0);
    job.advance(0.25);
    EXPECT_DOUBLE_EQ(said(), 0.25) << "outside of parts the worker says what it likes";
}

// Two steps without parts of their own, and threads that report in another order.
TEST(JobPart, NeverFalls) {
    Job job;
    job.begin_stage("smooth");
    job.advance(1.0);  // by a step that knew of no parts
    const JobPart part(job, 0.2, 0.6);
    EXPECT_DOUBLE_EQ(job.progress().fraction, 0.2);
    job.advance(0.75);
    job.advance(0.25);
    EXPECT_DOUBLE_EQ(job.progress().fraction, 0.5);
    {
        const JobPart inner(job, 0.0, 0.5);
        EXPECT_DOUBLE_EQ(job.progress().fraction, 0.5);
        job.advance(1.0);
        EXPECT_DOUBLE_EQ(job.progress().fraction, 0.5);
    }
    job.advance(1.0);
    EXPECT_DOUBLE_EQ(job.progress().fraction, 0.6);
}

TEST(JobPart, EndsWithItsStageAndHearsACancel) {
    Job job;
    job.begin_stage("smooth");
    {
        const JobPart part(job, 0.5, 1.0);
        job.begin_stage("thin");
        job.advance(0.5);
        EXPECT_DOUBLE_EQ(job.progress().fraction, 0.5);
    }
    job.advance(0.25);
    EXPECT_DOUBLE_EQ(job.progress().fraction, 0.25);
    job.cancel();
    EXPECT_THROW(JobPart(job, 0.0, 1.0), Cancelled);
}

TEST(Job, StopsTheWorkerAtItsNextReport) {
    Job job;
    bool stopped = false;
    std::thread worker([&] {
        try {
            job.begin_stage("endless");
            for (;;) job.advance(0.0);
        } catch (const Cancelled&) {
            stopped = true;
        }
    });
    while (job.progress().stage_number == 0) std::this_thread::yield();
    job.cancel();
    worker.join();
    EXPECT_TRUE(stopped);
}

TEST(Job, AsksThoseWhoKnowNoJobToStop) {
    Job job;
    const std::stop_token stop = job.stop_token();
    EXPECT_FALSE(stop.stop_requested());
    EXPECT_NO_THROW(throw_if_stopped(stop));
    job.cancel();
    EXPECT_TRUE(job.cancelled());
    EXPECT_TRUE(stop.stop_requested());
    EXPECT_THROW(throw_if_stopped(stop), Cancelled);
    EXPECT_NO_THROW(throw_if_stopped({}));
}

}  // namespace
}  // namespace hepatica
