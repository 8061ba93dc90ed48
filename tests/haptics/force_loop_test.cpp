// SPDX-License-Identifier: GPL-3.0-or-later
// One tick of the loop: nothing in free space, no more than the limits, the same bits again, the
// hand as commands once a step, and quiet where the device is lost.
#include "core/haptics/force_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/haptics/wall.h"

namespace hepatica {
namespace {

using test::press;
using test::WallPress;

HapticPose swinging(double t) {
    return {.at_mm = Vec3(20.0 * std::sin(9.0 * t), 5.0 * t, 30.0 * std::cos(7.0 * t)),
            .turned = Eigen::Quaterniond(Eigen::AngleAxisd(std::sin(3.0 * t), Vec3::UnitY()))};
}

LocalModel free_tool(const Vec3& centre_mm = Vec3::Zero()) {
    LocalModel model;
    model.tool = true;
    model.centre_mm = centre_mm;
    return model;
}

// A loop and all that it speaks to.
struct Bench {
    SimulatedDevice device;
    TripleBuffer<LocalModel> models;
    std::vector<Command> posted;
    std::uint64_t number = 0;  // of the last command
    ForceLoop loop;

    explicit Bench(const SimulatedHand& hand, const HapticTraits& traits = {})
        : device(hand, traits), loop(device, models, [this](Command c) {
              posted.push_back(std::move(c));
              return ++number;
          }) {}
    void hand_over(const LocalModel& model) {
        models.back() = model;
        models.publish();
    }
};

TEST(ForceLoop, FreeSpaceIsExactlyNothing) {
    Bench bench({.encoder_mm = 0.02, .latency_periods = 1, .jitter_periods = 2, .path = swinging});
    for (int i = 0; i < 2000; ++i) {
        if (i % 17 == 0) bench.hand_over(free_tool(Vec3(i, 0, 0)));
        const Tick tick = bench.loop.tick();
        ASSERT_TRUE(tick.tool);
        ASSERT_EQ(tick.force.both(), Vec6(Vec6::Zero())) << i;
        ASSERT_EQ(bench.device.acting().both(), Vec6(Vec6::Zero()));
    }
}

TEST(ForceLoop, WithoutAToolItDoesNothing) {
    Bench bench({.path = swinging});
    for (int i = 0; i < 100; ++i) {
        if (i == 50) bench.hand_over({});
        const Tick tick = bench.loop.tick();
        EXPECT_FALSE(tick.tool);
        EXPECT_EQ(tick.force.both(), Vec6(Vec6::Zero()));
    }
    EXPECT_TRUE(bench.posted.empty());
}

TEST(ForceLoop, AnotherToolIsLedFromWhereItIs) {
    Bench bench({.path = [](double t) { return HapticPose{.at_mm = Vec3(10.0 * t, 0, 0)}; }});
    LocalModel model = free_tool(Vec3(1, 0, 0));
    bench.hand_over(model);
    for (int i = 0; i < 50; ++i) bench.loop.tick();
    model = free_tool(Vec3(80, 0, 0));
    model.tool_number = 1;
    bench.hand_over(model);
    bench.loop.tick();
    bench.posted.clear();
    for (int i = 0; i < 50; ++i) bench.loop.tick();
    int moves = 0;
    for (const Command& command : bench.posted)
        if (const auto* move = std::get_if<MoveTool>(&command)) {
            EXPECT_NEAR(move->target_mm.x(), 80.0, 2.0);
            ++moves;
        }
    EXPECT_GT(moves, 0);
}

TEST(ForceLoop, KeepsWithinTheDevicesLimits) {
    WallPress setup;
    setup.traits.force_limit_un = 2e5;
    setup.hand.spring_un_per_mm = 3e6;
    setup.seconds = 5.0;
    const auto result = press(setup);
    EXPECT_LE(result.most_force_un, 2e5 * (1.0 + 1e-12));
    EXPECT_GE(result.most_force_un, 1.99e5);
}

TEST(ForceLoop, TheSameSeedGivesTheSameBits) {
    WallPress setup;
    setup.seconds = 3.0;
    setup.hand.encoder_mm = 0.02;
    setup.hand.latency_periods = 1;
    setup.hand.jitter_periods = 3;
    const double first = press(setup).sum;
    EXPECT_EQ(press(setup).sum, first);
    setup.hand.seed = 2;
    EXPECT_NE(press(setup).sum, first);
}

// The handle's way leads the tool from where it was taken; what turns it comes in parts that add
// up.
TEST(ForceLoop, ThePoseBecomesCommandsOnceAStep) {
    Bench bench({.spring_un_per_mm = 5e8, .damping_un_s_per_mm = 4e5, .path = swinging});
    const Vec3 taken(7, 8, 9);
    bench.hand_over(free_tool(taken));
    bench.loop.tick();
    const HapticPose start{bench.device.at_mm(), swinging(0.0).turned};
    bench.posted.clear();
    Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();
    int moves = 0;
    for (int step = 0; step < 10; ++step) {
        for (int i = 0; i < 17; ++i) {
            if (i == 16) bench.hand_over(free_tool(Vec3(1, 1, 1)));  // wherever it is by then
            bench.loop.tick();
        }
        for (const Command& command : bench.posted) {
            if (const auto* move = std::get_if<MoveTool>(&command)) {
                ++moves;
                EXPECT_EQ(move->share, 1.0);
                EXPECT_FALSE(move->over_s);
                EXPECT_NEAR((move->target_mm - taken - bench.device.at_mm() + start.at_mm).norm(),
                            0.0, 1e-9);
            } else {
                const Vec3 by = std::get<TurnTool>(command).by_rad;
                turned = Eigen::AngleAxisd(by.norm(), by.normalized()) * turned;
            }
        }
        bench.posted.clear();
    }
    EXPECT_EQ(moves, 10);
    const HapticPose seen{Vec3::Zero(), swinging(bench.device.time_s() - 1e-3).turned};
    EXPECT_NEAR(way_between({Vec3::Zero(), turned * start.turned}, seen).norm(), 0.0, 1e-6);
}

// A session that rests makes no steps: it is told all the same, and left alone while the hand
// rests.
TEST(ForceLoop, AHandThatMovesWakesASessionThatRests) {
    SimulatedHand hand;
    hand.path = [](double t) { return HapticPose{.at_mm = Vec3(t < 1.0 ? 0.0 : 5.0, 0, 0)}; };
    Bench bench(hand);
    bench.hand_over(free_tool());
    for (int i = 0; i < 990; ++i) bench.loop.tick();
    EXPECT_TRUE(bench.posted.empty());
    for (int i = 0; i < 60; ++i) bench.loop.tick();
    EXPECT_GE(bench.posted.size(), 2u);
    EXPECT_LE(bench.posted.size(), 4u);
}

// A handle that turns by a thousandth of a radian about y in each period, up to a limit, and is
// held where it is.
class TurningDevice final : public HapticDevice {
  public:
    explicit TurningDevice(double most_rad) : most_rad_(most_rad) {}
    const HapticTraits& traits() const override { return traits_; }
    std::optional<HapticSample> read() noexcept override {
        const double turned_rad = std::min(most_rad_, 1e-3 * static_cast<double>(number_));
        const Eigen::AngleAxisd turned(turned_rad, Vec3::UnitY());
        return HapticSample{{Vec3::Zero(), Eigen::Quaterniond(turned)}, ++number_, 0.0};
    }
    void write(const HapticForce&) noexcept override {}

  private:
    HapticTraits traits_;
    double most_rad_;
    std::uint64_t number_ = 0;
};

constexpr double beside_mm = 10.0, pressed_un = 1e5;

// Pressed from below, beside its centre: turning the tool about y presses more.
LocalModel pressed_beside_its_centre() {
    LocalModel model = free_tool();
    model.contacts = {{Vec3(beside_mm, 0, 0), -Vec3::UnitZ(), pressed_un}};
    model.compliance = Eigen::MatrixXd::Constant(1, 1, 1e-6);
    return model;
}

// By how much the force grows per radian: the contact in series with the coupling.
double stiffness_un_per_rad(const HapticTraits& traits) {
    const double give = 1e-6 + 1.0 / coupling_limit(traits.damping_un_s_per_mm, traits) +
                        beside_mm * beside_mm / coupling_limit(traits.turn_damping_un_mm_s, traits);
    return beside_mm / give;
}

// A loop that a turning handle leads, and no control of passivity.
struct TurningBench {
    TurningDevice device;
    TripleBuffer<LocalModel> models;
    std::uint64_t turns = 0;
    ForceLoop loop;

    explicit TurningBench(double most_rad)
        : device(most_rad),
          loop(device, models, [this](const Command&) { return ++turns; }, {.controlled = false}) {}
    void hand_over(const LocalModel& model) {
        models.back() = model;
        models.publish();
    }
    double force_after(int ticks) {
        double force = 0.0;
        for (int i = 0; i < ticks; ++i) force = loop.tick().force.force_un.z();
        return force;
    }
};

// A tool that is hindered, by whatever turned it.
TEST(ForceLoop, WhatTheToolHasStillToTurnIsFelt) {
    TurningBench bench(0.0);
    LocalModel model = pressed_beside_its_centre();
    model.left_rad = Vec3(0, 0.01, 0);
    bench.hand_over(model);
    EXPECT_NEAR(bench.force_after(40),
                pressed_un + 0.01 * stiffness_un_per_rad(bench.device.traits()), 1e-3 * pressed_un);
    EXPECT_EQ(bench.turns, 0u);
}

// What was posted is felt on until a model has it.
TEST(ForceLoop, ATurnThatIsUnderWayIsFeltOn) {
    TurningBench bench(1.0);
    bench.hand_over(pressed_beside_its_centre());
    double last = 0.0;
    for (int i = 0; i < 40; ++i) {
        const double force = bench.loop.tick().force.force_un.z();
        EXPECT_GE(force, last) << i;
        last = force;
    }
    EXPECT_EQ(bench.turns, 2u);
    const double stiffness = stiffness_un_per_rad(bench.device.traits());
    EXPECT_NEAR(last, pressed_un + 0.039 * stiffness, 1e-3 * pressed_un);
}

// A command that comes in the middle of a step is not in that step's model.
TEST(ForceLoop, ATurnThatNoStepHasTakenOutlastsAModel) {
    TurningBench bench(0.02);
    LocalModel model = pressed_beside_its_centre();
    bench.hand_over(model);
    const double turned = pressed_un + 0.02 * stiffness_un_per_rad(bench.device.traits());
    EXPECT_NEAR(bench.force_after(40), turned, 1e-3 * pressed_un);
    ASSERT_EQ(bench.turns, 2u);
    bench.hand_over(model);
    EXPECT_NEAR(bench.force_after(40), turned, 1e-3 * pressed_un);
    model.commands_taken = bench.turns;
    model.left_rad = Vec3(0, 0.02, 0);  // taken, but hindered
    bench.hand_over(model);
    EXPECT_NEAR(bench.force_after(40), turned, 1e-3 * pressed_un);
    model.left_rad.setZero();
    bench.hand_over(model);
    EXPECT_NEAR(bench.force_after(40), pressed_un, 1e-3 * pressed_un);
}

// The pads' forces of a new step come in over that step, not at once.
TEST(ForceLoop, ANewModelDoesNotJerk) {
    Bench bench({.mass_g = 1e9});  // a handle that stays
    LocalModel model = free_tool();
    model.contacts = {{Vec3::Zero(), -Vec3::UnitZ(), 1e5}};
    model.compliance = Eigen::MatrixXd::Constant(1, 1, 1e-6);
    bench.hand_over(free_tool());
    bench.loop.tick();
    bench.hand_over(model);
    double last = 0.0;
    for (int i = 0; i < 17; ++i) {
        const double force = bench.loop.tick().force.force_un.z();
        EXPECT_LE(std::abs(force - last), 1e5 / 16.0);
        last = force;
    }
    for (int i = 0; i < 3; ++i) last = bench.loop.tick().force.force_un.z();
    EXPECT_NEAR(last, 1e5, 1.0);
    bench.hand_over(free_tool());
    EXPECT_EQ(bench.loop.tick().force.force_un.z(), 0.0);  // free is free at once
}

TEST(ForceLoop, ALostDeviceGetsNoForceAndLeadsNothing) {
    Bench bench({.mass_g = 1e9});
    LocalModel model = free_tool();
    model.contacts = {{Vec3::Zero(), -Vec3::UnitZ(), 1e5}};
    model.compliance = Eigen::MatrixXd::Constant(1, 1, 1e-6);
    bench.hand_over(model);
    for (int i = 0; i < 50; ++i) bench.loop.tick();
    ASSERT_GT(bench.loop.tick().force.force_un.norm(), 0.0);
    bench.device.lose();
    const Tick tick = bench.loop.tick();
    EXPECT_TRUE(tick.lost);
    EXPECT_EQ(tick.force.both(), Vec6(Vec6::Zero()));
    bench.posted.clear();
    for (int i = 0; i < 50; ++i) EXPECT_TRUE(bench.loop.tick().lost);
    EXPECT_TRUE(bench.posted.empty());
}

TEST(ForceLoop, WhatIsNoNumberReachesNoMotorAndAPoseThatIsNoneIsALoss) {
    Bench bench({.mass_g = 1e9});
    LocalModel model = free_tool();
    model.contacts = {{Vec3::Zero(), -Vec3::UnitZ(), std::nan("")}};
    model.compliance = Eigen::MatrixXd::Constant(1, 1, 1e-6);
    bench.hand_over(model);
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(bench.loop.tick().force.both(), Vec6(Vec6::Zero()));
        EXPECT_EQ(bench.device.acting().both(), Vec6(Vec6::Zero()));
    }
    model.contacts[0].force_un = 1e5;  // and the next model is felt again
    bench.hand_over(model);
    EXPECT_GT(bench.loop.tick().force.force_un.norm(), 0.0);
    SimulatedHand gone;
    gone.path = [](double t) { return HapticPose{.at_mm = Vec3(t > 0.01 ? NAN : 0.0, 0, 0)}; };
    Bench nowhere(gone);
    for (int i = 0; i < 30; ++i) nowhere.loop.tick();
    EXPECT_TRUE(nowhere.loop.tick().lost);
}

// Answers with work that is no number from its tenth sample on.
class WorklessDevice final : public HapticDevice {
  public:
    const HapticTraits& traits() const override { return traits_; }
    std::optional<HapticSample> read() noexcept override {
        ++number_;
        return HapticSample{{}, number_, number_ < 10 ? 0.0 : std::nan("")};
    }
    void write(const HapticForce&) noexcept override {}

  private:
    HapticTraits traits_;
    std::uint64_t number_ = 0;
};

TEST(ForceLoop, WorkThatIsNoNumberIsALoss) {
    WorklessDevice device;
    TripleBuffer<LocalModel> models;
    ForceLoop loop(device, models, [](const Command&) { return std::uint64_t{0}; });
    for (int i = 1; i < 10; ++i) EXPECT_FALSE(loop.tick().lost) << i;
    EXPECT_TRUE(loop.tick().lost);
}

// Answers for ever with the sample of one moment.
class StuckDevice final : public HapticDevice {
  public:
    const HapticTraits& traits() const override { return traits_; }
    std::optional<HapticSample> read() noexcept override { return HapticSample{{}, 1, 0.0}; }
    void write(const HapticForce& force) noexcept override { written = force; }
    HapticForce written{Vec3::Ones(), Vec3::Zero()};

  private:
    HapticTraits traits_;
};

TEST(ForceLoop, ADeviceThatIsStuckCountsAsLost) {
    StuckDevice device;
    TripleBuffer<LocalModel> models;
    ForceLoop loop(device, models, [](const Command&) { return std::uint64_t{0}; });
    int ticks = 0;
    while (!loop.tick().lost && ticks < 1000) ++ticks;
    EXPECT_GT(ticks, 20);
    EXPECT_LT(ticks, 200);
    EXPECT_EQ(device.written.both(), Vec6(Vec6::Zero()));
}

}  // namespace
}  // namespace hepatica
