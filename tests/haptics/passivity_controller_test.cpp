// SPDX-License-Identifier: GPL-3.0-or-later
// The loop never makes energy: a hand that presses a stiff wall for a minute and trembles gets no
// more out of it than it has put in, however late and unevenly messages come. Each claim has its
// control: without the controller, or with a coupling beyond the limit of Colgate and Schenkel, it
// does.
#include "core/haptics/passivity_controller.h"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/haptics/wall.h"

namespace hepatica {
namespace {

using test::press;
using test::WallPress;
using test::WallResult;

// What the forces that are under way in the first touches may give before their account has come
// in; it does not grow with time. 0.05 mJ: a third of a newton over a third of a millimetre is
// more.
constexpr double overdraft_nj = 5e4;

// Latency and jitter each way in ms, whether the tool follows into the wall, the encoder's step.
using Lateness = std::tuple<int, int, bool, double>;
class PassivityTest : public testing::TestWithParam<Lateness> {
  protected:
    WallPress setup() const {
        const auto [latency, jitter, follows, encoder_mm] = GetParam();
        WallPress press;
        press.hand.latency_periods = static_cast<std::uint64_t>(latency);
        press.hand.jitter_periods = static_cast<std::uint64_t>(jitter);
        press.hand.encoder_mm = encoder_mm;
        press.follows = follows;
        return press;
    }
};
INSTANTIATE_TEST_SUITE_P(Lateness, PassivityTest,
                         testing::Combine(testing::Values(0, 1, 2, 5), testing::Values(0, 1),
                                          testing::Bool(), testing::Values(0.0, 0.02)));

TEST_P(PassivityTest, AMinuteAtAStiffWallMakesNoEnergy) {
    WallPress setup = this->setup();
    for (const unsigned seed : {1u, 2u, 3u}) {
        setup.hand.seed = seed;
        const WallResult result = press(setup);
        EXPECT_LT(result.most_work_nj, overdraft_nj) << "seed " << seed;
        EXPECT_LT(result.most_mm, 3.0);
        EXPECT_GT(result.most_force_un, 5e4);     // the wall is felt
        if (std::get<1>(GetParam()) == 0) break;  // nothing is drawn
    }
}

TEST_P(PassivityTest, WithoutTheControllerItDoes) {
    WallPress setup = this->setup();
    setup.options.controlled = false;
    EXPECT_GT(press(setup).work_nj, 5.0 * overdraft_nj);
}

// The coupling of Colgate and Schenkel's equality, times four.
TEST_P(PassivityTest, WithACouplingBeyondTheLimitItDoes) {
    WallPress setup = this->setup();
    const HapticTraits traits = SimulatedDevice(setup.hand, setup.traits).traits();
    setup.options.coupling_un_per_mm =
        4.0 * setup.traits.damping_un_s_per_mm / (0.5 * traits.period_s + traits.latency_s);
    EXPECT_GT(press(setup).most_work_nj, 5.0 * overdraft_nj);
    setup.options.controlled = false;
    EXPECT_GT(press(setup).work_nj, 100.0 * overdraft_nj);
}

TEST(PassivityController, LeavesASpringAloneThatGivesBackNoMoreThanItTook) {
    WallPress setup;
    setup.follows = false;
    setup.options.coupling_un_per_mm = 1e4;  // far below the limit
    const WallResult with = press(setup);
    setup.options.controlled = false;
    const WallResult without = press(setup);
    EXPECT_NEAR(with.last_force_un, without.last_force_un, 0.02 * without.most_force_un);
    EXPECT_NEAR(with.sum, without.sum, 0.05 * without.sum);
    EXPECT_GT(without.last_force_un, 0.0);
}

// Two ticks by hand: a force along the motion is given as far as the credit goes.
TEST(PassivityController, GivesNoMoreThanItsCredit) {
    PassivityController controller({.damping_un_s_per_mm = 1e3, .turn_damping_un_mm_s = 1e9});
    const HapticForce out{.force_un = Vec3(1e6, 0, 0), .torque_un_mm = Vec3::Zero()};
    HapticSample sample;
    controller.limited(out, sample);
    for (int i = 0; i < 50; ++i) {
        ++sample.number;
        sample.pose.at_mm.x() += 0.1;  // 100 mm/s, without any work so far
        const HapticForce given = controller.limited(out, sample);
        EXPECT_GT(controller.damping_un_s_per_mm(), 0.0);
        EXPECT_LE(given.force_un.x(), i < 10 ? 1e6 : 1e3);
    }
    sample.work_nj = -1e9;  // the hand has put in a joule
    ++sample.number;
    sample.pose.at_mm.x() += 0.1;
    EXPECT_EQ(controller.limited(out, sample).force_un.x(), 1e6);
    EXPECT_EQ(controller.damping_un_s_per_mm(), 0.0);
}

TEST(PassivityController, LeavesFreeSpaceFreeWhateverTheDebt) {
    PassivityController controller(HapticTraits{});
    HapticSample sample;
    for (int i = 0; i < 20; ++i) {
        ++sample.number;
        sample.pose.at_mm.x() += 0.1;
        sample.work_nj += 1e6;  // it has given, and never got
        EXPECT_EQ(controller.limited({}, sample).both(), Vec6(Vec6::Zero()));
    }
    EXPECT_LT(controller.credit_nj(), -1e6);
}

TEST(PassivityController, CouplingObeysColgateAndSchenkel) {
    HapticTraits traits;
    traits.damping_un_s_per_mm = 2e3;
    for (const double latency_s : {0.0, 1e-3, 1e-2}) {
        traits.latency_s = latency_s;
        const double stiffness = coupling_limit(traits.damping_un_s_per_mm, traits);
        const double braking = 0.6 * traits.damping_un_s_per_mm;
        EXPECT_GT(traits.damping_un_s_per_mm,
                  stiffness * (0.5 * traits.period_s + latency_s) + braking);
        EXPECT_GT(stiffness * (0.5 * traits.period_s + latency_s), 0.2 * 2e3);
    }
}

}  // namespace
}  // namespace hepatica
