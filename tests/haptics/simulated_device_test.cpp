// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated device moves as its equation says, sees what it is told to see, and counts the work
// of its force.
#include "core/haptics/simulated_device.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hepatica {
namespace {

HapticForce along_x(double force_un) {
    return {.force_un = Vec3(force_un, 0, 0), .torque_un_mm = Vec3::Zero()};
}

// A damped spring that a constant force pulls from rest, in closed form.
TEST(SimulatedDevice, SwingsAsTheDampedSpringThatItIs) {
    const SimulatedHand hand{.mass_g = 100.0, .spring_un_per_mm = 4e5, .damping_un_s_per_mm = 2e3};
    SimulatedDevice device(hand, {});
    const double decay = hand.damping_un_s_per_mm / (2.0 * hand.mass_g);
    const double swing = std::sqrt(hand.spring_un_per_mm / hand.mass_g - decay * decay);
    const double end = 1e6 / hand.spring_un_per_mm;
    device.write(along_x(1e6));
    for (int i = 1; i <= 500; ++i) {
        ASSERT_TRUE(device.read());
        const double t = device.time_s();
        const double x = end * (1.0 - std::exp(-decay * t) * (std::cos(swing * t) +
                                                              decay / swing * std::sin(swing * t)));
        ASSERT_NEAR(device.at_mm().x(), x, 1e-10) << i;
    }
    EXPECT_NEAR(device.work_nj(), 1e6 * device.at_mm().x(), 1e-3);
}

TEST(SimulatedDevice, MessagesComeLateInTheirOrderByItsLatencyAndJitter) {
    SimulatedHand hand{.latency_periods = 3, .jitter_periods = 2};
    hand.path = [](double t) { return HapticPose{.at_mm = Vec3(100.0 * t, 0, 0)}; };
    SimulatedDevice device(hand, {});
    EXPECT_NEAR(device.traits().latency_s, 0.010, 1e-12);
    std::uint64_t last = 0;
    bool jittered = false;
    for (std::uint64_t i = 1; i <= 300; ++i) {
        const auto sample = device.read();
        ASSERT_TRUE(sample);
        ASSERT_GE(sample->number, last);
        if (i > 5) {
            ASSERT_GE(i - sample->number, 3u);
            ASSERT_LE(i - sample->number, 5u);
            jittered = jittered || i - sample->number != 3;
        }
        last = sample->number;
    }
    EXPECT_TRUE(jittered);
    device.write(along_x(1e6));
    int periods = 0;
    while (device.acting().force_un.x() == 0.0 && periods < 20) device.read(), ++periods;
    EXPECT_GE(periods, 4);
    EXPECT_LE(periods, 6);
}

TEST(SimulatedDevice, CountsItsWorkFromWhatTheEncoderSees) {
    SimulatedDevice device({.encoder_mm = 0.05}, {});
    device.write(along_x(5e5));
    HapticSample last;
    for (int i = 0; i < 200; ++i) last = *device.read();
    const double steps = last.pose.at_mm.x() / 0.05;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    EXPECT_NEAR(last.pose.at_mm.x(), device.at_mm().x(), 0.0251);
    EXPECT_NEAR(last.work_nj, device.work_nj(), 5e5 * 0.0501);
    EXPECT_GT(device.work_nj(), 1e5);
}

TEST(SimulatedDevice, CountsTheWorkOfTorques) {
    PortWork work;
    const HapticForce force{.torque_un_mm = Vec3(0, 0, 2e6)};
    HapticPose pose;
    work.pass(pose, force);
    pose.turned = Eigen::AngleAxisd(0.1, Vec3::UnitZ());
    EXPECT_NEAR(work.pass(pose, force), 2e5, 1e-3);
    pose.turned = Eigen::AngleAxisd(-0.1, Vec3::UnitZ());
    EXPECT_NEAR(work.pass(pose, force), -2e5, 1e-3);
}

TEST(SimulatedDevice, GivesNothingOnceItIsLost) {
    SimulatedDevice device({}, {});
    EXPECT_TRUE(device.read());
    device.lose();
    EXPECT_FALSE(device.read());
}

}  // namespace
}  // namespace hepatica
