// SPDX-License-Identifier: GPL-3.0-or-later
// A stop that is asked for within a step of a session: it is heard there, and what was begun is no
// step. Whoever goes on all the same goes on from the last good state, and a replay agrees.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/base/error.h"
#include "core/scene/deform_part.h"
#include "core/scene/world.h"
#include "core/session/replay.h"
#include "core/session/session.h"
#include "tests/session/failing_stepper.h"
#include "tests/session/recorded.h"
#include "tests/session/small_patient.h"
#include "tests/support/asked_to_stop.h"

namespace hepatica {
namespace {

using test::Fault;
using test::middle_of;
using test::small_patient;

class StoppedStep : public testing::Test {
  protected:
    explicit StoppedStep(const SceneSpec& scene = default_scene()) {
        Job job;
        session_ =
            std::make_unique<Session>(small_patient(), scene, job, test::failing_back_end(fault_));
        recording_ = test::keep_recording(*session_);
        session_->post(GrabPoint{middle_of(small_patient()->tree, 0)});
        session_->post(MoveGrab{middle_of(small_patient()->tree, 0) + Vec3(5, 0, 0)});
    }

    SessionStep play(int steps) {
        SessionStep last;
        for (int i = 0; i < steps; ++i) last = session_->step();
        return last;
    }
    // Somebody asks for a stop while the body is half through a step.
    SessionStep stop_within_a_step() {
        std::stop_source source;
        *fault_ = [&](const std::string& call) {
            if (call != "step") return;
            source.request_stop();
            throw Cancelled();
        };
        const SessionStep stopped = session_->step(source.get_token());
        *fault_ = nullptr;
        return stopped;
    }
    std::vector<Vec3> shape() const {
        const auto now = session_->world().deform()->positions_mm();
        return {now.begin(), now.end()};
    }

    std::shared_ptr<Fault> fault_ = std::make_shared<Fault>();
    std::unique_ptr<Session> session_;
    std::shared_ptr<Recording> recording_;
};

TEST_F(StoppedStep, IsNeitherShownNorRecordedNorCounted) {
    int watched = 0;
    session_->watch([&](const auto&, const auto&, const auto&) { return ++watched > 0; });
    play(75);
    session_->update_frame();
    const SessionStep stopped = stop_within_a_step();
    EXPECT_TRUE(stopped.stopped);
    EXPECT_FALSE(session_->update_frame());
    EXPECT_EQ(session_->frame().step, 75u);
    EXPECT_EQ(recording_->steps.size(), 75u);
    EXPECT_EQ(watched, 75);
    const SessionStep next = session_->step();
    EXPECT_FALSE(next.stopped);
    EXPECT_EQ(next.step, 76u);
    EXPECT_EQ(recording_->steps.size(), 76u);
    EXPECT_EQ(watched, 76);
}

// What a watch waits for may never come.
TEST_F(StoppedStep, IsHeardByAWatchThatWaits) {
    std::stop_source source;
    bool heard = false;
    session_->watch([&](const auto&, const auto&, const std::stop_token& stop) {
        source.request_stop();
        heard = stop.stop_requested();
        return true;
    });
    session_->step(source.get_token());
    EXPECT_TRUE(heard);
}

TEST_F(StoppedStep, TheNextGoesBackToTheLastGoodStateAndAReplayAgrees) {
    play(60);
    const std::vector<Vec3> snapshot = shape();
    session_->post(MoveGrab{middle_of(small_patient()->tree, 0) + Vec3(0, 5, 0)});
    play(15);
    EXPECT_NE(shape(), snapshot);
    session_->post(SetTether{7.0});
    stop_within_a_step();
    session_->step();
    EXPECT_EQ(shape(), snapshot);
    session_->update_frame();
    EXPECT_TRUE(session_->frame().statistics.paused);
    EXPECT_NE(session_->frame().statistics.message.find("told to within a step"),
              std::string::npos);
    // What was chosen in the step that was stopped stays chosen, and stands in the recording.
    EXPECT_EQ(session_->world().deform()->body().tether_pa_per_mm2, 7.0);
    session_->post(RestoreSnapshot{});
    const std::uint64_t end = play(20).state_hash;
    EXPECT_NE(shape(), snapshot);
    Job job;
    const ReplayResult replayed = replay(*recording_, small_patient(), job);
    EXPECT_FALSE(replayed.diverged_at.has_value()) << *replayed.diverged_at;
    EXPECT_EQ(replayed.state_hash, end);
}

TEST_F(StoppedStep, OfAJobIsItsCancel) {
    play(10);
    Job job;
    *fault_ = [&](const std::string& call) {
        if (call == "begin step") job.cancel();
    };
    EXPECT_THROW(session_->step(job), Cancelled);
    EXPECT_EQ(recording_->steps.size(), 10u);
}

TEST_F(StoppedStep, AStopThatComesWhenTheStepIsMadeChangesNothing) {
    std::stop_source source;
    *fault_ = [&](const std::string& call) {
        if (call == "step") source.request_stop();
    };
    const SessionStep made = session_->step(source.get_token());
    EXPECT_FALSE(made.stopped);
    EXPECT_EQ(recording_->steps.size(), 1u);
}

// Nobody would wait for the end of such a step: some minutes for each solve.
SceneSpec endless() {
    SceneSpec scene = default_scene();
    scene.deform->setting = {.solver = LinearSolverKind::block_jacobi,
                             .linear = {.energy_tolerance = 0.0, .max_iterations = 1'000'000},
                             .newton_iterations = 100,
                             .substeps = 64};
    return scene;
}

class EndlessStep : public StoppedStep {
  protected:
    EndlessStep() : StoppedStep(endless()) {}
};

TEST_F(EndlessStep, EndsWithTheSimulationThread) {
    std::atomic<int> begun{0}, ended{0};
    *fault_ = [&](const std::string& call) {
        if (call == "begin step") ++begun;
        if (call == "step") ++ended;
    };
    {
        const std::jthread thread([&](const std::stop_token& stop) { session_->run(stop); });
        while (begun == 0) std::this_thread::yield();
        EXPECT_FALSE(session_->waits_for_command()) << "it is in the step";
    }
    EXPECT_EQ(ended, 0);
    EXPECT_TRUE(recording_->steps.empty());
}

// A command may wait for what is computed on a thread of its own.
TEST(StoppedInjection, IsNotWaitedForAndCountsNoStep) {
    SceneSpec still = default_scene();
    still.deform.reset();
    Job job;
    Session session(small_patient(), still, job);
    const auto recording = test::keep_recording(session);
    session.post(InjectDrug{.point_mm = small_patient()->tree.nodes[0].position_mm,
                            .void_fraction = 0.4,
                            .second_phase = "gas"});
    session.post(FinishInjection{});
    const SessionStep stopped = session.step(test::asked_to_stop());
    EXPECT_TRUE(stopped.stopped);
    EXPECT_TRUE(recording->steps.empty());
    EXPECT_EQ(session.step().step, 1u);
}

// The clock of a scene with long steps is waited for, too.
TEST(RunningSession, EndsWhileItWaitsForItsNextStep) {
    SceneSpec slow = default_scene();
    slow.dt_s = 1.0;
    Job job;
    Session session(small_patient(), slow, job);
    std::atomic<int> shown{0};
    session.on_frame([&] { ++shown; });
    session.post(GrabPoint{middle_of(small_patient()->tree, 0)});
    session.post(MoveGrab{middle_of(small_patient()->tree, 0) + Vec3(5, 0, 0)});
    std::jthread thread([&](const std::stop_token& stop) { session.run(stop); });
    while (shown == 0) std::this_thread::yield();
    const auto asked = std::chrono::steady_clock::now();
    thread.request_stop();
    thread.join();
    EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::milliseconds(900));
}

}  // namespace
}  // namespace hepatica
