// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces that do not take a step: what they do instead makes no energy, also where others are in
// their way, and keeps the momentum of what nothing holds.
#include "core/deform/step/declined_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include "core/deform/step/assembly.h"
#include "core/deform/step/backward_euler.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

using Overdrawn = EnergyLimiter::Overdrawn;

double uniform_in(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

Vec3 vector_in(std::mt19937_64& random, double most) {
    const double x = uniform_in(random, -most, most), y = uniform_in(random, -most, most);
    return {x, y, uniform_in(random, -most, most)};
}

// A body with `count` single tetrahedra behind what it has, which may touch each other.
struct Crumbs {
    BodyDescription description;
    std::size_t first = 0;  // node of them

    void add_crumb(const Vec3& at_mm) {
        test::add_mesh({.vertices_mm = {at_mm, at_mm + Vec3(3, 0, 0), at_mm + Vec3(0, 3, 0),
                                        at_mm + Vec3(0, 0, 3)},
                        .tetrahedra = {{0, 1, 2, 3}}},
                       description.mesh);
    }

    Body body() {
        description.material.damping_ratio = 0.0;
        description.self.emplace();
        description.fixed.resize(description.mesh.vertices_mm.size(), 0);
        return build_body(description, ElementModel::corotated, ElementOrder::linear);
    }

    // Each of them flies its own way and spins by one to three radians a step.
    BodyState whirling(const Body& body, std::mt19937_64& random) const {
        BodyState state{body.rest_positions_mm,
                        std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
        for (std::size_t f = first; f < body.mass_g.size(); f += 4) {
            const Vec3 axis = vector_in(random, 1.0);
            const Vec3 spin = uniform_in(random, 60.0, 200.0) / axis.norm() * axis;
            const Vec3 flight = vector_in(random, 100.0);
            for (std::size_t i = f; i < f + 4; ++i)
                state.velocities_mm_per_s[i] =
                    spin.cross(Vec3(state.positions_mm[i] - state.positions_mm[f])) + flight;
        }
        return state;
    }
};

struct Play {
    double made = 0.0;           // largest energy made in a step, of what was stored before
    double momentum_lost = 0.0;  // largest change in a step, of all that moves
};

Vec3 momentum_of(const Body& body, const BodyState& state) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < body.mass_g.size(); ++i)
        sum += body.mass_g[i] * state.velocities_mm_per_s[i];
    return sum;
}

// `extra_solves` as in NewtonSettings: without any, no step can be cut in halves.
void play(const Body& body, const PotentialList& potentials, BodyState state, int extra_solves,
          Play& all) {
    BackwardEuler integrator(body,
                             {.extra_solves = extra_solves, .linear = {.energy_tolerance = 1e-13}},
                             make_block_jacobi_solver());
    double moving = 0.0;
    for (std::size_t i = 0; i < body.mass_g.size(); ++i)
        moving += body.mass_g[i] * state.velocities_mm_per_s[i].norm();
    for (int k = 0; k < 30; ++k) {
        const Vec3 before = momentum_of(body, state);
        const EnergyLedger ledger = integrator.advance(state, 1.0 / 60.0, potentials).energy;
        const double made = explained_change(ledger) + ledger.imbalance;
        all.made = std::max(all.made, made / (stored_energy(ledger) - made));
        all.momentum_lost =
            std::max(all.momentum_lost, (momentum_of(body, state) - before).norm() / moving);
    }
}

// A beam of 40 mm along x, and crumbs in a row along it from x on.
Crumbs beside_a_beam(int count, double x_mm) {
    Crumbs crumbs;
    test::add_mesh(kuhn_brick(Vec3(40, 8, 8), {8, 2, 2}), crumbs.description.mesh);
    crumbs.first = crumbs.description.mesh.vertices_mm.size();
    for (int c = 0; c < count; ++c) crumbs.add_crumb(Vec3(x_mm + 6 * c, 9, 2));
    return crumbs;
}

// Crumbs whirl beside a beam that is pulled hard: they make energy that the beam pays for, so that
// they do not take the step. Without them at its end the beam's way may lead into one of them.
TEST(DeclinedPieces, ArePressedByNothingThatTakesTheStep) {
    Play all;
    for (const int seed : {6, 25, 26, 27, 29, 30, 34}) {
        Crumbs crumbs = beside_a_beam(3, 10.0);
        for (const Vec3& x : crumbs.description.mesh.vertices_mm)
            crumbs.description.fixed.push_back(x.x() == 0.0);
        const Body body = crumbs.body();
        PotentialList pull(body);
        const int tip = static_cast<int>(crumbs.first) - 1;
        const Grab grab{.vertices = {tip, -1, -1, -1},
                        .weights = {1, 0, 0, 0},
                        .target_mm = body.rest_positions_mm[tip] + Vec3(0, 30, 0),
                        .stiffness_un_per_mm = 1e6,
                        .force_limit_un = 1e9};
        pull.set_grabs(std::span(&grab, 1));
        for (const int extra_solves : {24, 0}) {
            std::mt19937_64 random(seed);
            play(body, pull, crumbs.whirling(body, random), extra_solves, all);
        }
    }
    EXPECT_LT(all.made, 1e-8);
}

// The same beside a beam that nothing holds, and which was stretched and springs back.
TEST(DeclinedPieces, KeepTheMomentumOfWhatNothingHolds) {
    Play all;
    for (int seed = 0; seed < 15; ++seed) {
        Crumbs crumbs = beside_a_beam(6, 2.0);
        const Body body = crumbs.body();
        std::mt19937_64 random(seed);
        BodyState state = crumbs.whirling(body, random);
        for (std::size_t i = 0; i < crumbs.first; ++i) state.positions_mm[i].x() *= 1.6;
        play(body, PotentialList(body), std::move(state), 24, all);
    }
    EXPECT_LT(all.made, 1e-8);
    EXPECT_LT(all.momentum_lost, 1e-9);
}

// Three crumbs side by side, whose step was to stop them all.
class DeclinedCrumbs : public testing::Test {
  protected:
    DeclinedCrumbs() : body_(three()), limiter_(body_, Assembly(body_).plan()), weight_(body_) {
        std::mt19937_64 random(1);
        start_ = crumbs_.whirling(body_, random);
        step_.emplace(StepUnderway{.potentials = weight_,
                                   .start = start_,
                                   .dt_s = 1.0 / 600.0,
                                   .before = {},
                                   .velocity = std::vector<Vec3>(12, Vec3::Zero()),
                                   .positions = start_.positions_mm});
        declined_.emplace(body_, limiter_, *step_);
    }

    bool add(std::vector<int> crumbs, bool flies, bool unpaid) {
        Overdrawn pieces{.flies = flies, .unpaid = unpaid};
        for (const int c : crumbs)
            for (int i = 0; i < 4; ++i) pieces.nodes.push_back(4 * c + i);
        return declined_->add(std::span(&pieces, 1));
    }
    Vec3 momentum(const std::vector<Vec3>& velocity, int first, int last) const {
        Vec3 sum = Vec3::Zero();
        for (int i = 4 * first; i < 4 * (last + 1); ++i) sum += body_.mass_g[i] * velocity[i];
        return sum;
    }
    // By how much any two nodes of these crumbs come nearer to each other or farther apart, mm.
    double strain_mm(int first, int last) const {
        const std::vector<Vec3> v = declined_->velocities();
        double most = 0.0;
        for (int i = 4 * first; i < 4 * (last + 1); ++i)
            for (int j = 4 * first; j < i; ++j) {
                const Vec3 apart = start_.positions_mm[i] - start_.positions_mm[j];
                const Vec3 then = apart + step_->dt_s * (v[i] - v[j]);
                most = std::max(most, std::abs(then.norm() - apart.norm()));
            }
        return most;
    }
    bool stands(int crumb) const {
        const std::vector<Vec3> v = declined_->velocities();
        return std::all_of(v.begin() + 4 * crumb, v.begin() + 4 * crumb + 4,
                           [](const Vec3& x) { return x.isZero(0.0); });
    }

  private:
    Body three() {
        for (int c = 0; c < 3; ++c) crumbs_.add_crumb(Vec3(6 * c, 0, 0));
        return crumbs_.body();
    }

    Crumbs crumbs_;
    Body body_;
    EnergyLimiter limiter_;
    PotentialList weight_;

  protected:
    BodyState start_;
    std::optional<StepUnderway> step_;
    std::optional<DeclinedPieces> declined_;
};

TEST_F(DeclinedCrumbs, FlyOnAloneThenTogetherThenStand) {
    const std::vector<Vec3>& began = start_.velocities_mm_per_s;
    ASSERT_TRUE(add({0}, true, false));
    EXPECT_LT((momentum(declined_->velocities(), 0, 0) - momentum(began, 0, 0)).norm(), 1e-12);
    EXPECT_LT(strain_mm(0, 0), 1e-12);
    EXPECT_TRUE(stands(1) && stands(2));  // as the step has it
    // It meets another one: both together as one, so that neither comes nearer to the other.
    ASSERT_TRUE(add({0, 1}, true, true));
    EXPECT_LT((momentum(declined_->velocities(), 0, 1) - momentum(began, 0, 1)).norm(), 1e-12);
    EXPECT_GT((momentum(declined_->velocities(), 0, 0) - momentum(began, 0, 0)).norm(), 1e-6);
    EXPECT_LT(strain_mm(0, 1), 1e-12);
    EXPECT_GT(strain_mm(1, 2), 1e-3);
    // One of them made energy all the same: both stand, and so does what meets them then.
    ASSERT_TRUE(add({0}, true, true));
    EXPECT_TRUE(stands(0) && stands(1));
    EXPECT_FALSE(add({0}, true, true));
    step_->velocity = began;
    EXPECT_FALSE(stands(2));
    ASSERT_TRUE(add({1, 2}, true, true));
    EXPECT_TRUE(stands(0) && stands(1) && stands(2));
}

TEST_F(DeclinedCrumbs, StandWhereSomethingHoldsThem) {
    step_->velocity = start_.velocities_mm_per_s;
    ASSERT_TRUE(add({0, 1}, false, false));
    EXPECT_TRUE(stands(0) && stands(1));
    EXPECT_FALSE(stands(2));
}

// On a common flight each has another momentum than it had: that alone is nothing to mend.
TEST_F(DeclinedCrumbs, StayOnTheirWayWhereNoEnergyWasMade) {
    ASSERT_TRUE(add({0, 1}, true, true));
    EXPECT_FALSE(add({0}, true, false));
    EXPECT_FALSE(add({0, 2}, true, false));
    EXPECT_LT(strain_mm(0, 1), 1e-12);
    EXPECT_FALSE(stands(0));
}

}  // namespace
}  // namespace hepatica
