// SPDX-License-Identifier: GPL-3.0-or-later
// What friction between surfaces promises: forces that are the gradient of its energy and come in
// opposite pairs; Coulomb's limit; a stiffness that is that of the force; nothing outside of steps.
#include "core/deform/potentials/self_friction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/deform/potentials/potential_list.h"
#include "core/deform/solvers/node_loops.h"
#include "core/deform/step/assembly.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

using test::crossed_bars;
using test::random_field;

constexpr double mu = 0.3, dt_s = 0.01;

Body rubbing() {
    BodyDescription bars = crossed_bars(1.0);
    bars.self->friction = mu;
    return build_body(bars, ElementModel::corotated, ElementOrder::linear);
}

// Two bars pressed together, of which the upper one has gone by some creeps or far more, and both
// are a little shaken.
class SelfFrictionTest : public testing::TestWithParam<double> {
  protected:
    SelfFrictionTest() : body_(rubbing()), list_(body_) {
        start_.positions_mm = body_.rest_positions_mm;
        start_.velocities_mm_per_s.assign(body_.node_count(), Vec3::Zero());
        const double pad = body_.self_pad->thickness_mm;
        for (std::size_t i = 0; i < start_.positions_mm.size(); ++i)
            if (upper(i)) start_.positions_mm[i].z() -= 1.0 - 0.6 * pad;
        list_.begin_step(start_, dt_s, {});
        const double by_mm = GetParam() * creep_mm(body_, dt_s);
        x_ = start_.positions_mm;
        const auto noise = random_field(x_.size(), 0.2 * by_mm, 3);
        for (std::size_t i = 0; i < x_.size(); ++i)
            x_[i] += noise[i] + (upper(i) ? by_mm * Vec3(0.8, -0.6, 0.1) : Vec3(Vec3::Zero()));
    }
    bool upper(std::size_t i) const { return i >= start_.positions_mm.size() / 2; }
    const SelfFriction& friction() const { return *list_.self_friction(); }
    std::vector<Vec3> forces(const std::vector<Vec3>& x) const {
        std::vector<Vec3> force(x.size(), Vec3::Zero());
        friction().add_forces(x, force);
        return force;
    }

    Body body_;
    PotentialList list_;
    BodyState start_;
    std::vector<Vec3> x_;
};

TEST_P(SelfFrictionTest, ForcesAreTheGradientOfTheEnergy) {
    const std::vector<Vec3> force = forces(x_);
    const double h = 1e-4 * GetParam() * creep_mm(body_, dt_s);
    double size = 0.0, error = 0.0;
    for (const Vec3& f : force) size = std::max(size, f.norm());
    ASSERT_GT(size, 1.0);
    std::vector<Vec3> x = x_;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            if (force[i].isZero(0.0)) continue;
            x[i][c] = x_[i][c] + h;
            const double above = friction().energy(x, x);
            x[i][c] = x_[i][c] - h;
            const double below = friction().energy(x, x);
            x[i][c] = x_[i][c];
            error = std::max(error, std::abs(force[i][c] + (above - below) / (2 * h)) / size);
        }
    EXPECT_LT(error, 1e-4);
}

TEST_P(SelfFrictionTest, ForcesAreOppositeAgainstTheSlipAndAtMostTheLimit) {
    Vec3 sum = Vec3::Zero(), on_upper = Vec3::Zero();
    const std::vector<Vec3> force = forces(x_);
    double size = 0.0, pressed = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
        sum += force[i];
        size += force[i].norm();
        if (upper(i)) on_upper += force[i];
    }
    for (const SurfaceContact& contact : list_.self()->contacts(start_.positions_mm))
        pressed += contact.force_un;
    EXPECT_LT(sum.norm(), 1e-12 * size);
    EXPECT_LT(on_upper.normalized().dot(Vec3(0.8, -0.6, 0)), -0.95);
    EXPECT_LE(on_upper.norm(), mu * pressed);
    if (GetParam() > 2.0) {
        EXPECT_GT(on_upper.norm(), 0.9 * mu * pressed);
    }
}

// Times a field: the change of the force, centred.
TEST_P(SelfFrictionTest, StiffnessAndCouplingAreThatOfTheForce) {
    const double h = 1e-4 * GetParam() * creep_mm(body_, dt_s);
    const auto d = random_field(x_.size(), 1.0, 5);
    BlockMatrix matrix;
    Assembly(body_).gather_stiffness(0.0, matrix);
    friction().add_stiffness(x_, 2.0, matrix);
    std::vector<Vec3> within, beside(x_.size(), Vec3::Zero()), again = beside;
    multiply(matrix, d, within);
    friction().add_product(x_, 2.0, d, matrix, again);
    friction().add_coupling(x_, 2.0, d, beside);
    std::vector<Vec3> above = x_, below = x_;
    for (std::size_t i = 0; i < x_.size(); ++i) {
        above[i] += h * d[i];
        below[i] -= h * d[i];
    }
    const std::vector<Vec3> after = forces(above), before = forces(below);
    double size = 0.0, error = 0.0, twice = 0.0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const Vec3 exact = -(after[i] - before[i]) / h;
        size = std::max(size, exact.norm());
        error = std::max(error, (within[i] + beside[i] - exact).norm());
        twice = std::max(twice, (within[i] - again[i]).norm());
    }
    ASSERT_GT(size, 0.0);
    EXPECT_LT(error, 1e-4 * size);
    EXPECT_LT(twice, 1e-9 * size);
    EXPECT_TRUE(friction().coupled(x_));
}

TEST_P(SelfFrictionTest, IsNotThereOutsideOfAStep) {
    EXPECT_GT(friction().energy(x_, x_), 0.0);
    EXPECT_EQ(friction().energy(start_.positions_mm, x_), 0.0);
    list_.end_step();
    EXPECT_EQ(friction().energy(x_, x_), 0.0);
    EXPECT_FALSE(friction().coupled(x_));
}

INSTANTIATE_TEST_SUITE_P(StickingAndSlipping, SelfFrictionTest, testing::Values(0.3, 0.8, 30.0));

// Contacts that slip far beyond the creep.
class SlippingSelfFriction : public SelfFrictionTest {
  protected:
    // K u at node i, where u moves that node alone, once friction was told these forces.
    Vec3 stiffness_at(std::size_t i, const std::vector<Vec3>& told) {
        list_.foresee(x_, told);
        std::vector<Vec3> u(x_.size(), Vec3::Zero()), product = u;
        u[i] = Vec3(0.8, -0.6, 0.1);
        friction().add_coupling(x_, 1.0, u, product);
        BlockMatrix matrix;
        Assembly(body_).gather_stiffness(0.0, matrix);
        friction().add_product(x_, 1.0, u, matrix, product);
        return product[i];
    }
};

// A force that holds one corner of a contact holds all contacts of that corner, as if all were
// held.
TEST_P(SlippingSelfFriction, EveryCornerOfAContactIsToldWhetherItWillHold) {
    const std::vector<Vec3> none(x_.size(), Vec3::Zero()), rubbed = forces(x_);
    std::vector<Vec3> all = none;
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = (upper(i) ? -1e12 : 1e12) * Vec3(0.8, -0.6, 0.1);
    int corners = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (rubbed[i].norm() < 1e-9) continue;
        ++corners;
        std::vector<Vec3> one = none;
        one[i] = all[i];
        const Vec3 held = stiffness_at(i, all);
        EXPECT_GT((held - stiffness_at(i, none)).norm(), 0.5 * held.norm()) << i;
        EXPECT_LT((held - stiffness_at(i, one)).norm(), 1e-6 * held.norm()) << i;
    }
    EXPECT_GT(corners, 8);
}

INSTANTIATE_TEST_SUITE_P(Far, SlippingSelfFriction, testing::Values(30.0));

}  // namespace
}  // namespace hepatica
