// SPDX-License-Identifier: GPL-3.0-or-later
// The local model: its force is the gradient of a convex energy, is the simulation's where the tool
// stands still, never pulls, and is never stiffer than the coupling.
#include "core/haptics/local_model.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <random>

namespace hepatica {

// What this program and the room allocate comes by here: see CMakeLists.txt.
std::atomic<int> allocations = 0;
void* plain_malloc(std::size_t bytes) __asm__("__real_malloc");
void* plain_new(std::size_t bytes) __asm__("__real__Znwm");
void* counted_malloc(std::size_t bytes) __asm__("__wrap_malloc");
void* counted_new(std::size_t bytes) __asm__("__wrap__Znwm");
void* counted_malloc(std::size_t bytes) {
    ++allocations;
    return plain_malloc(bytes);
}
void* counted_new(std::size_t bytes) {
    ++allocations;
    return plain_new(bytes);
}

namespace {

// A patch of so many contacts on a cap, with a compliance that couples them all.
LocalModel patch(int contacts, unsigned seed) {
    std::mt19937 draw(seed);
    std::normal_distribution<double> normal;
    LocalModel model;
    model.tool = true;
    model.centre_mm = Vec3(1, 2, 3);
    for (int i = 0; i < contacts; ++i) {
        const Vec3 out = Vec3(0.5 * normal(draw), 0.5 * normal(draw), -1.0).normalized();
        model.contacts.push_back({model.centre_mm + 4.0 * out, out, 2e3 * std::abs(normal(draw))});
    }
    const Eigen::MatrixXd mixed =
        Eigen::MatrixXd::NullaryExpr(contacts, contacts, [&] { return 1e-3 * normal(draw); });
    model.compliance = 1e-3 * mixed * mixed.transpose() / contacts +
                       1e-6 * Eigen::MatrixXd::Identity(contacts, contacts);
    return model;
}

Vec6 way(std::mt19937& draw, double size) {
    std::normal_distribution<double> normal;
    Vec6 drawn;
    for (int i = 0; i < 6; ++i) drawn[i] = size * (i < 3 ? 1.0 : 0.1) * normal(draw);
    return drawn;
}

class LocalModelTest : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Contacts, LocalModelTest, testing::Values(1, 7, 64));

TEST_P(LocalModelTest, IsWhatTheSimulationSaysWhereTheToolStandsStill) {
    const LocalModel model = patch(GetParam(), 1);
    LocalForce local(1e6, 1e8);
    local.take(model);
    HapticForce sum;
    for (const LocalContact& contact : model.contacts) {
        sum.force_un -= contact.force_un * contact.normal;
        sum.torque_un_mm -=
            (contact.at_mm - model.centre_mm).cross(contact.force_un * contact.normal);
    }
    const HapticForce there = local.at(Vec6::Zero());
    EXPECT_NEAR((there.force_un - sum.force_un).norm(), 0.0, 1e-8 * sum.force_un.norm());
    EXPECT_NEAR((there.torque_un_mm - sum.torque_un_mm).norm(), 0.0, 1e-8 * sum.force_un.norm());
}

TEST_P(LocalModelTest, ForceIsTheNegativeGradientOfTheEnergy) {
    LocalForce local(1e6, 1e8);
    local.take(patch(GetParam(), 2));
    std::mt19937 draw(3);
    int let_go = 0;
    for (int trial = 0; trial < 20; ++trial) {
        const Vec6 at = way(draw, 0.02 * (trial + 1));
        const Vec6 force = local.at(at).both();
        if (force.isZero(0.0)) ++let_go;
        constexpr double h = 1e-6;
        for (int i = 0; i < 6; ++i) {
            Vec6 more = at, less = at;
            more[i] += h, less[i] -= h;
            local.at(more);
            const double above = local.energy_nj();
            local.at(less);
            const double gradient = (above - local.energy_nj()) / (2.0 * h);
            ASSERT_NEAR(force[i], -gradient, 1e-5 * (1.0 + force.norm()) + 0.5)
                << trial << ' ' << i;
        }
    }
    EXPECT_LT(let_go, 20);
}

// One-sided: contacts press or let go, and what is pressed obeys the compliance.
TEST_P(LocalModelTest, NeverPullsAndLetsGoInTheEnd) {
    LocalForce local(1e6, 1e8);
    const LocalModel model = patch(GetParam(), 4);
    local.take(model);
    for (const double up : {0.0, 0.05, 0.5, 50.0}) {
        const HapticForce force = local.at((Vec6() << 0, 0, up, 0, 0, 0).finished());
        EXPECT_GE(force.force_un.z(), 0.0);
        if (up == 50.0) {
            EXPECT_EQ(force.force_un, Vec3(Vec3::Zero()));
            EXPECT_EQ(force.torque_un_mm, Vec3(Vec3::Zero()));
        }
    }
}

// The energy is convex and its curvature at most the coupling's stiffness: forces at two poses
// differ against the way, and by no more than that stiffness times the way.
TEST_P(LocalModelTest, IsPassiveAndNeverStifferThanTheCoupling) {
    constexpr double stiffness = 2e5, turn_stiffness = 1e7;
    LocalForce local(stiffness, turn_stiffness);
    local.take(patch(GetParam(), 5));
    std::mt19937 draw(6);
    for (int trial = 0; trial < 200; ++trial) {
        const Vec6 from = way(draw, 0.3), to = way(draw, 0.3);
        const Vec6 change = local.at(to).both() - local.at(from).both();
        const Vec6 gone = to - from;
        const double gain = -change.dot(gone);
        EXPECT_GE(gain, -1e-6 * change.norm() * gone.norm());
        EXPECT_LE(gain, stiffness * gone.head<3>().squaredNorm() +
                            turn_stiffness * gone.tail<3>().squaredNorm() + 1e-6);
    }
}

// The loop's thread must not wait for a lock of the heap, however many contacts are pressed.
TEST_P(LocalModelTest, AllocatesNothingBetweenTwoModels) {
    const LocalModel model = patch(GetParam(), 8);
    LocalForce local(1e6, 1e8);
    const int before = allocations;
    local.take(model);
    EXPECT_GT(allocations, before);
    std::mt19937 draw(9);
    std::vector<Vec6> ways;
    for (int trial = 0; trial < 100; ++trial) ways.push_back(way(draw, 0.02 * trial));
    const int taken = allocations;
    int let_go = 0;
    for (const Vec6& there : ways) let_go += local.at(there).both().isZero(0.0) ? 1 : 0;
    EXPECT_EQ(allocations, taken);
    EXPECT_LT(let_go, 100);
}

TEST(LocalForce, OfNothingIsExactlyNothing) {
    LocalForce local(1e6, 1e8);
    LocalModel free;
    free.tool = true;
    local.take(free);
    std::mt19937 draw(7);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(local.at(way(draw, 10.0)).both(), Vec6(Vec6::Zero()));
}

// One contact in closed form: coupling and compliance in series.
TEST(LocalForce, OfOneContactIsTwoSpringsInSeries) {
    LocalForce local(1e5, 1e30);
    LocalModel model;
    model.tool = true;
    model.contacts = {{Vec3::Zero(), -Vec3::UnitZ(), 1e4}};
    model.compliance = Eigen::MatrixXd::Constant(1, 1, 1.0 / 3e5);
    local.take(model);
    const double series = 1.0 / (1.0 / 1e5 + 1.0 / 3e5);
    for (const double down : {-1.0, -0.1, 0.0, 0.2, 1.0}) {
        const double force = local.at((Vec6() << 0, 0, -down, 0, 0, 0).finished()).force_un.z();
        EXPECT_NEAR(force, std::max(0.0, 1e4 + series * down), 1e-6);
    }
}

}  // namespace
}  // namespace hepatica
