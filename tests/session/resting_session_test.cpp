// SPDX-License-Identifier: GPL-3.0-or-later
// Where nothing can change, a running session makes no steps and no frames, and a command wakes it.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

#include "core/session/session.h"
#include "tests/session/new_session.h"
#include "tests/session/small_patient.h"

namespace hepatica {
namespace {

using test::middle_of;
using test::new_session;
using test::small_patient;

// A session on a thread of its own, and what it says of its frames.
class Running {
  public:
    explicit Running(const SceneSpec& spec = default_scene(),
                     std::chrono::milliseconds held_up = std::chrono::milliseconds(0))
        : session_(new_session(spec)) {
        session_->on_frame([this, held_up] {
            ++told_;
            std::this_thread::sleep_for(held_up);
        });
        thread_ = std::jthread([this](const std::stop_token& stop) { session_->run(stop); });
    }

    Session& session() { return *session_; }
    const Frame& newest() {
        session_->update_frame();
        return session_->frame();
    }
    bool comes_to(const std::function<bool(const Frame&)>& condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
        while (std::chrono::steady_clock::now() < end) {
            if (condition(newest())) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }
    bool comes_to_rest() {
        return comes_to([](const Frame& frame) { return frame.statistics.resting; });
    }
    // It waits for a command; a first one, which changes nothing, is the next step and the next
    // frame, and it waits again.
    void expect_nothing_happens() {
        ASSERT_TRUE(comes_to([this](const Frame&) { return session_->waits_for_command(); }));
        const std::uint64_t step = newest().step;
        const int told = told_;
        session_->post(PlayDrug{false});
        EXPECT_TRUE(comes_to([this](const Frame&) { return session_->waits_for_command(); }));
        EXPECT_EQ(newest().step, step + 1);
        EXPECT_EQ(told_, told + 1);
    }

  private:
    std::unique_ptr<Session> session_;
    std::atomic<int> told_{0};
    std::jthread thread_;
};

TEST(RestingSession, MakesNoStepsAndNoFramesUntilACommandComes) {
    Running running;
    ASSERT_TRUE(running.comes_to_rest());
    running.expect_nothing_happens();
    const std::uint64_t step = running.newest().step;
    const Vec3 start = middle_of(small_patient()->tree, 1);
    running.session().post(GrabPoint{start});
    running.session().post(MoveGrab{start + Vec3(3, 0, 0)});
    ASSERT_TRUE(
        running.comes_to([&](const Frame& frame) { return frame.grab && frame.step > step + 5; }));
    EXPECT_FALSE(running.session().waits_for_command()) << "it follows the hand";
    EXPECT_FALSE(running.newest().statistics.resting);
    // The time at rest was no delay.
    EXPECT_GT(running.newest().statistics.real_time_factor, 0.2);
    running.session().post(ReleaseGrab{});
    ASSERT_TRUE(running.comes_to_rest());
    running.expect_nothing_happens();
}

// Each step stands for a tenth of a millisecond and takes more than one.
TEST(RunningSession, SaysThatItIsSlowerThanTheClock) {
    SceneSpec spec = default_scene();
    spec.dt_s = 1e-4;
    Running running(spec, std::chrono::milliseconds(1));
    const Vec3 start = middle_of(small_patient()->tree, 1);
    running.session().post(GrabPoint{start});
    running.session().post(MoveGrab{start + Vec3(3, 0, 0), 1.0});
    EXPECT_TRUE(running.comes_to(
        [](const Frame& frame) { return frame.statistics.real_time_factor < 0.2; }));
    EXPECT_GT(running.newest().statistics.real_time_factor, 0.0);
}

TEST(RestingSession, AnInjectionThatHasRunOutIsRest) {
    Running running;
    ASSERT_TRUE(running.comes_to_rest());
    running.session().post(SetDrugSpeed{100.0});
    running.session().post(InjectDrug{.point_mm = small_patient()->tree.nodes[0].position_mm});
    ASSERT_TRUE(running.comes_to([](const Frame& frame) { return frame.drug.playing; }));
    ASSERT_TRUE(running.comes_to_rest());
    EXPECT_FALSE(running.newest().drug.playing);
    EXPECT_EQ(running.newest().drug.time_s, running.newest().drug.end_s);
    running.expect_nothing_happens();
}

TEST(RestingSession, APauseIsRestInMidPull) {
    Running running;
    const Vec3 start = middle_of(small_patient()->tree, 1);
    running.session().post(GrabPoint{start});
    running.session().post(MoveGrab{start + Vec3(3, 0, 0)});
    running.session().post(SetPaused{true});
    // Not the rest before the commands came.
    ASSERT_TRUE(running.comes_to([](const Frame& frame) {
        return frame.statistics.paused && frame.statistics.resting && frame.grab;
    }));
    running.expect_nothing_happens();
    running.session().post(SetPaused{false});
    EXPECT_TRUE(running.comes_to([](const Frame& frame) { return !frame.statistics.paused; }));
}

TEST(RestingSession, IsStillWokenByAnInjectionThatIsBeingComputed) {
    Running running;
    ASSERT_TRUE(running.comes_to_rest());
    running.session().post(SetPaused{true});
    running.session().post(InjectDrug{.point_mm = small_patient()->tree.nodes[0].position_mm,
                                      .void_fraction = 0.4,
                                      .second_phase = "gas"});
    EXPECT_TRUE(
        running.comes_to([](const Frame& frame) { return frame.drug.arrival_s != nullptr; }));
}

// Without parts that move there is nothing to wait for.
TEST(RestingSession, OfASceneThatDoesNotDeformRestsAtOnce) {
    SceneSpec still = default_scene();
    still.deform.reset();
    Running running(still);
    ASSERT_TRUE(running.comes_to_rest());
    EXPECT_LE(running.newest().step, 1u);
}

}  // namespace
}  // namespace hepatica
