// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever goes wrong in a command, a step or a frame: the session stops, says so, and goes on from
// its last good state when it is told to.
#include <gtest/gtest.h>

#include <chrono>
#include <new>
#include <optional>
#include <stdexcept>
#include <thread>

#include "core/scene/deform_part.h"
#include "core/scene/world.h"
#include "core/session/replay.h"
#include "core/session/session.h"
#include "tests/session/failing_stepper.h"
#include "tests/session/recorded.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using test::Fault;
using test::middle_of;
using test::small_patient;

struct Thrown {
    std::string name;
    std::function<void()> raise;
    std::string said;  // in the message
};

std::vector<Thrown> errors() {
    return {
        {"bad_alloc", [] { throw std::bad_alloc(); }, "memory"},
        {"runtime_error", [] { throw std::runtime_error("the disk melted"); }, "the disk melted"},
        {"no exception class", [] { throw 42; }, "without a name"}};
}

// A session whose back end fails at one call, in one way, as soon as it is armed.
struct Faulty {
    std::shared_ptr<Fault> fault = std::make_shared<Fault>();
    std::unique_ptr<Session> session;
    std::shared_ptr<Recording> recording;

    explicit Faulty(const SceneSpec& scene = default_scene()) {
        Job job;
        session =
            std::make_unique<Session>(small_patient(), scene, job, test::failing_back_end(fault));
        recording = test::keep_recording(*session);
        session->post(GrabPoint{middle_of(small_patient()->tree, 0)});
        session->post(MoveGrab{middle_of(small_patient()->tree, 0) + Vec3(5, 0, 0)});
    }
    void arm(const std::string& call, const Thrown& error) {
        *fault = [call, error](const std::string& now) {
            if (now == call) error.raise();
        };
    }
    void mend() { *fault = nullptr; }
    SessionStep play(int steps) {
        SessionStep last;
        for (int i = 0; i < steps; ++i) last = session->step();
        return last;
    }
    std::vector<Vec3> shape() const {
        const auto now = session->world().deform()->positions_mm();
        return {now.begin(), now.end()};
    }
    const Frame& frame() {
        session->update_frame();
        return session->frame();
    }
};

void expect_stopped(Faulty& play, const Thrown& error) {
    const FrameStatistics& said = play.frame().statistics;
    EXPECT_TRUE(said.paused);
    EXPECT_TRUE(said.diverged);
    EXPECT_NE(said.message.find(error.said), std::string::npos) << said.message;
    EXPECT_NE(said.message.find("resume"), std::string::npos) << said.message;
    EXPECT_FALSE(play.frame().grab.has_value());
}

// Restoring goes on; a new pull moves the body; and the whole is a recording like any other.
void expect_to_go_on(Faulty& play) {
    play.session->post(RestoreSnapshot{});
    play.session->step();
    EXPECT_FALSE(play.frame().statistics.paused);
    EXPECT_FALSE(play.frame().statistics.diverged);
    EXPECT_TRUE(play.frame().statistics.message.empty());
    play.session->post(GrabPoint{middle_of(small_patient()->tree, 1)});
    play.session->post(MoveGrab{middle_of(small_patient()->tree, 1) + Vec3(0, 5, 0)});
    const std::vector<Vec3> before = play.shape();
    const std::uint64_t end = play.play(20).state_hash;
    EXPECT_NE(play.shape(), before);
    Job job;
    const ReplayResult replayed = replay(*play.recording, small_patient(), job);
    EXPECT_FALSE(replayed.diverged_at.has_value()) << *replayed.diverged_at;
    EXPECT_EQ(replayed.state_hash, end);
}

TEST(Barrier, AFailedStepGoesBackToTheLastGoodState) {
    for (const Thrown& error : errors()) {
        SCOPED_TRACE(error.name);
        Faulty play;
        play.play(60);
        const std::vector<Vec3> snapshot = play.shape();
        play.session->post(MoveGrab{middle_of(small_patient()->tree, 0) + Vec3(0, 5, 0)});
        play.play(15);
        EXPECT_NE(play.shape(), snapshot);
        EXPECT_FALSE(play.frame().statistics.diverged);
        play.arm("step", error);
        play.session->step();
        play.mend();
        EXPECT_EQ(play.shape(), snapshot);
        expect_stopped(play, error);
        play.play(3);
        EXPECT_EQ(play.shape(), snapshot);
        expect_stopped(play, error);
        expect_to_go_on(play);
    }
}

TEST(Barrier, AFailedCommandGoesBackToTheLastGoodStateAndKeepsTheOldSetting) {
    for (const Thrown& error : errors()) {
        for (const auto& [call, command] :
             {std::pair{"set_gravity", Command(SetGravity{Vec3(0, 0, -9810)})},
              std::pair{"make", Command(SetTether{1.0})}, std::pair{"make", Command(SetWall{0.5})},
              std::pair{"make", Command(UseSetting{{.order = ElementOrder::quadratic}})}}) {
            SCOPED_TRACE(error.name + " in " + call);
            Faulty play;
            play.play(60);
            const std::vector<Vec3> snapshot = play.shape();
            const std::string setting = play.frame().statistics.setting;
            play.play(10);
            play.arm(call, error);
            play.session->post(command);
            play.session->step();
            play.mend();
            EXPECT_EQ(play.shape(), snapshot);
            expect_stopped(play, error);
            EXPECT_EQ(play.frame().statistics.setting, setting);
            EXPECT_EQ(play.session->world().deform()->body().tether_pa_per_mm2, 20.0);
            EXPECT_TRUE(play.session->world().deform()->body().stiffness_factor.empty());
            expect_to_go_on(play);
        }
    }
}

// Nothing can be read from the back end any more: neither the frame nor the way back succeed until
// it answers again, and nothing is lost by that.
TEST(Barrier, AFrameThatCannotBeMadeIsMadeAsSoonAsItCan) {
    for (const Thrown& error : errors()) {
        SCOPED_TRACE(error.name);
        Faulty play;
        play.play(60);
        const std::vector<Vec3> snapshot = play.shape();
        play.session->post(SetPaused{true});
        play.play(2);
        const std::uint64_t shown = play.frame().step;
        play.arm("positions", error);
        play.play(3);
        EXPECT_EQ(play.frame().step, shown);
        play.mend();
        play.play(1);
        EXPECT_EQ(play.frame().step, shown + 4);
        EXPECT_EQ(play.shape(), snapshot);
        expect_stopped(play, error);
        play.session->post(RestoreSnapshot{});
        play.session->step();
        EXPECT_FALSE(play.frame().statistics.diverged);
        EXPECT_FALSE(play.frame().statistics.paused);
    }
}

// The way back opens the hand and puts the tool away; a replay, which meets no fault, has to be
// told.
TEST(Barrier, AToolInTheHandIsPutAwayAndTheRecordingSaysSo) {
    SceneSpec touchable = default_scene();
    touchable.contact = ContactSpec{};
    Faulty play(touchable);
    play.session->post(AddTool{.radius_mm = 2.0,
                               .direction = Vec3(0, 0, -1),
                               .point_mm = middle_of(small_patient()->tree, 1)});
    for (int i = 0; i < 60; ++i) {
        play.session->post(ShiftTool{Vec3(0, 0, -0.1)});
        play.session->step();
    }
    ASSERT_TRUE(play.frame().tool.has_value());
    play.arm("step", errors().front());
    play.session->step();
    play.mend();
    expect_stopped(play, errors().front());
    EXPECT_FALSE(play.frame().tool.has_value());
    expect_to_go_on(play);
}

TEST(Barrier, AResetEndsIt) {
    Faulty play;
    play.play(20);
    play.arm("step", errors().front());
    play.session->step();
    play.mend();
    expect_stopped(play, errors().front());
    play.session->post(ResetWorld{});
    play.session->step();
    EXPECT_FALSE(play.frame().statistics.diverged);
    EXPECT_FALSE(play.frame().statistics.paused);
    EXPECT_TRUE(play.frame().statistics.message.empty());
}

TEST(Barrier, TheSimulationThreadLivesOnThroughAnyOfThem) {
    for (const Thrown& error : errors()) {
        SCOPED_TRACE(error.name);
        Faulty play;
        play.arm("step", error);
        {
            std::jthread thread([&](const std::stop_token& stop) { play.session->run(stop); });
            const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
            while (play.frame().step < 5 && std::chrono::steady_clock::now() < deadline) {
                play.session->post(PlayDrug{false});  // it rests while it is stopped
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
        }
        EXPECT_GE(play.frame().step, 5u);
        expect_stopped(play, error);
    }
}

// The window has plain words in place of a solver's, but none in place of the session's own.
TEST(WordsOfTheSolver, AreToldFromThoseOfTheSession) {
    const auto words = std::make_shared<std::string>("the body was slowed down");
    Job job;
    Session session(small_patient(), default_scene(), job,
                    test::failing_back_end(std::make_shared<Fault>(), words));
    const auto said = [&](const Command& command) {
        session.post(command);
        session.step();
        session.update_frame();
        return session.frame().statistics;
    };
    const Vec3 held = middle_of(small_patient()->tree, 0);
    const FrameStatistics of_solver = said(GrabPoint{held});
    EXPECT_EQ(of_solver.message, *words);
    EXPECT_TRUE(of_solver.message_of_solver);
    const FrameStatistics refused = said(InjectDrug{.pressure_model = "nonsense"});
    EXPECT_NE(refused.message.find("nonsense"), std::string::npos) << refused.message;
    EXPECT_FALSE(refused.message_of_solver);
    EXPECT_TRUE(refused.degraded);
    words->clear();
    const FrameStatistics none = said(MoveGrab{held});
    EXPECT_EQ(none.message, "");
    EXPECT_FALSE(none.message_of_solver);
}

}  // namespace
}  // namespace hepatica
