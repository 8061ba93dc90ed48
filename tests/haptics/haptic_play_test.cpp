// SPDX-License-Identifier: GPL-3.0-or-later
// The loop's thread: it runs while a device is attached and a tool is in hand, ends cleanly, and a
// device that is lost is no harm to the play.
#include "core/haptics/haptic_play.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "core/base/error.h"
#include "core/haptics/simulated_device.h"
#include "core/scene/deform_part.h"
#include "core/scene/world.h"
#include "tests/haptics/touchable_patient.h"
#include "tests/session/recorded.h"

namespace hepatica {
namespace {

using test::ball;
using test::new_session;
using test::touchable;
using testing::HasSubstr;

// Counts ticks and waits for them.
class Ticks {
  public:
    void see(const Tick& tick) {
        const std::scoped_lock lock(mutex_);
        ++count_;
        last_ = tick;
        changed_.notify_all();
    }
    template <class Good>
    bool wait_for(const Good& good) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, std::chrono::seconds(60),
                                 [&] { return good(count_, last_); });
    }
    int count() {
        const std::scoped_lock lock(mutex_);
        return count_;
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int count_ = 0;
    Tick last_;
};

class HapticPlayTest : public testing::Test {
  protected:
    HapticPlayTest() {
        haptics.on_tick([this](const Tick& tick) { ticks.see(tick); });
        session->on_frame([this] { haptics.after_step(); });
    }
    ~HapticPlayTest() override { session->on_frame({}); }

    std::shared_ptr<SimulatedDevice> device(double by_mm = 3.0) {
        SimulatedHand hand;
        hand.path = [by_mm](double t) {
            return HapticPose{.at_mm = Vec3(0, 0, -by_mm * std::min(1.0, t))};
        };
        return std::make_shared<SimulatedDevice>(
            hand, HapticTraits{.name = "simulated device", .damping_un_s_per_mm = 5e3});
    }
    void take_tool() { session->post(ball()); }

    std::unique_ptr<Session> session = new_session(touchable());
    Ticks ticks;
    HapticPlay haptics{*session};
};

TEST_F(HapticPlayTest, RunsOnlyWhileAToolIsInHand) {
    take_tool();
    session->step();
    EXPECT_EQ(ticks.count(), 0);  // no device
    session->post(RemoveTool{});
    session->step();
    haptics.attach(device());
    test::play(*session, 5);
    EXPECT_EQ(ticks.count(), 0);  // no tool
    take_tool();
    session->step();
    EXPECT_TRUE(ticks.wait_for([](int count, const Tick& t) { return count > 20 && t.tool; }));
    session->post(RemoveTool{});
    session->step();
    EXPECT_TRUE(ticks.wait_for([](int, const Tick& t) { return !t.tool; }));
    haptics.detach();
    const int before = ticks.count();
    take_tool();
    session->step();
    EXPECT_EQ(ticks.count(), before);
    EXPECT_EQ(haptics.message(), "");
}

TEST_F(HapticPlayTest, LeadsTheToolOfASessionThatRunsByItself) {
    take_tool();
    haptics.attach(device());
    std::jthread simulation([this](const std::stop_token& stop) { session->run(stop); });
    EXPECT_TRUE(ticks.wait_for(
        [](int, const Tick& t) { return t.contacts > 0 && t.force.force_un.z() > 1e3; }));
    haptics.detach();
    simulation.request_stop();
    simulation.join();
    EXPECT_TRUE(session->world().deform()->tool());
}

// A session that rests makes no frames: attaching asks for one.
TEST_F(HapticPlayTest, IsFeltInASessionThatRests) {
    take_tool();
    std::jthread simulation([this](const std::stop_token& stop) { session->run(stop); });
    while (!session->waits_for_command()) std::this_thread::yield();
    haptics.attach(device());
    EXPECT_TRUE(ticks.wait_for([](int, const Tick& t) { return t.tool; }));
}

// Under the thread sanitizer: an after_step() may end in the middle of the next attach().
TEST_F(HapticPlayTest, IsAttachedAgainAndAgainWhileASessionSteps) {
    take_tool();
    session->step();
    session->post(ShiftTool{Vec3(0, 0, -3.0)});
    std::jthread simulation([this](const std::stop_token& stop) {
        while (!stop.stop_requested()) session->step();
    });
    for (int i = 0; i < 200; ++i) haptics.attach(device());
    const int before = ticks.count();
    EXPECT_TRUE(ticks.wait_for([&](int count, const Tick& t) { return count > before && t.tool; }));
    haptics.detach();
}

TEST_F(HapticPlayTest, ALostDeviceIsSaidAndThePlayGoesOn) {
    take_tool();
    const auto pulled_out = device();
    pulled_out->lose();
    haptics.attach(pulled_out);
    session->step();
    EXPECT_TRUE(ticks.wait_for([](int, const Tick& t) { return t.lost; }));
    const std::uint64_t step = session->step().step;
    EXPECT_EQ(session->step().step, step + 1);
    while (haptics.message().empty()) std::this_thread::yield();
    EXPECT_THAT(haptics.message(), HasSubstr("simulated device no longer answers"));
    EXPECT_THAT(haptics.message(), HasSubstr("attach it again"));
    EXPECT_FALSE(session->frame().statistics.diverged);
    haptics.attach(device());
    session->step();
    EXPECT_TRUE(ticks.wait_for([](int, const Tick& t) { return t.tool; }));
    EXPECT_EQ(haptics.message(), "");
}

// The tool is led once in 50 ms, not once in a sixtieth of a second.
TEST(HapticPlayOfAnotherStep, LeadsTheToolOnceInAStepOfTheScene) {
    SceneSpec spec = touchable();
    spec.dt_s = 0.05;
    const auto session = new_session(spec);
    const auto recording = test::keep_recording(*session);
    Ticks ticks;
    HapticPlay haptics(*session);
    haptics.on_tick([&](const Tick& tick) { ticks.see(tick); });
    session->on_frame([&] { haptics.after_step(); });
    session->post(ball());
    session->step();
    SimulatedHand hand;
    hand.path = [](double t) {
        return HapticPose{.turned = Eigen::Quaterniond(Eigen::AngleAxisd(0.1 * t, Vec3::UnitX()))};
    };
    haptics.attach(std::make_shared<SimulatedDevice>(hand, HapticTraits{}));
    session->step();  // from its frame the loop learns of the tool
    EXPECT_TRUE(ticks.wait_for([](int count, const Tick&) { return count >= 120; }));
    haptics.detach();
    session->step();  // takes what was posted meanwhile
    int turns = 0;
    for (const Command& command : recording->steps.back().commands)
        turns += std::holds_alternative<TurnTool>(command) ? 1 : 0;
    EXPECT_GE(turns, 2);
    EXPECT_LE(turns, ticks.count() / 50);
    session->on_frame({});
}

TEST_F(HapticPlayTest, NoLongerSaysThatNothingIsFeltOnceItIsFeltAgain) {
    bool fails = true;
    HapticPlay failing(*session, [&](const DeformPart&, double, LocalModel&) {
        if (fails) throw std::runtime_error("no memory is left");
    });
    session->on_frame([&] { failing.after_step(); });
    failing.attach(device());
    session->step();
    EXPECT_EQ(failing.message(), "Nothing is felt: no memory is left");
    fails = false;
    session->step();
    EXPECT_EQ(failing.message(), "");
    fails = true;
    session->step();
    EXPECT_NE(failing.message(), "");
    failing.detach();
    EXPECT_EQ(failing.message(), "") << "of a device that is no longer there";
    session->on_frame({});
}

TEST_F(HapticPlayTest, RefusesTraitsThatCannotBe) {
    HapticTraits traits{.name = "Quill"};
    traits.damping_un_s_per_mm = 0.0;
    try {
        haptics.attach(std::make_shared<SimulatedDevice>(SimulatedHand{}, traits));
        FAIL() << "no damping was taken";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("Quill"));
        EXPECT_THAT(error.what(), HasSubstr("damping is 0"));
        EXPECT_THAT(error.what(), HasSubstr("docs/haptics.md"));
    }
}

// Without it nothing bounds the work that its steps may hide.
TEST_F(HapticPlayTest, RefusesAResolutionThatIsNoNumber) {
    for (const double resolution_mm : {std::nan(""), -0.1}) {
        try {
            haptics.attach(std::make_shared<SimulatedDevice>(
                SimulatedHand{.encoder_mm = resolution_mm}, HapticTraits{.name = "Quill"}));
            ADD_FAILURE() << resolution_mm << " was taken";
            haptics.detach();
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("Quill"));
            EXPECT_THAT(error.what(), HasSubstr("resolution [mm] is "));
        }
    }
}

}  // namespace
}  // namespace hepatica
