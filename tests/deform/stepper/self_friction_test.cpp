// SPDX-License-Identifier: GPL-3.0-or-later
// Vessels that rub against each other in their steps: Coulomb's law on a slope, momentum and energy
// of a collision, the ledger, sleep, and the same bits again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

using test::bar_at;
using test::copy_of;
using test::crossed_bars;

constexpr double mu = 0.4;

// A block above a slab that is held at its lower side: at rest so far from it that every pad is as
// thick.
BodyDescription block_on_a_slab(double friction, double damping_ratio) {
    BodyDescription body;
    test::add_mesh(bar_at(Vec3(60, 16, 3), {15, 4, 1}, Mat3::Identity(), Vec3(0, 0, -1.5)),
                   body.mesh);
    test::add_mesh(bar_at(Vec3(12, 8, 3), {4, 3, 1}, Mat3::Identity(), Vec3(-20.3, 0.2, 2.5)),
                   body.mesh);
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.z() < -2.9 ? 1 : 0);
    body.material.damping_ratio = damping_ratio;
    body.self.emplace();
    body.self->friction = friction;
    return body;
}

std::unique_ptr<Stepper> tilted(const BodyDescription& body, double angle) {
    auto stepper = make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-8},
                                           .newton_iterations = 8,
                                           .newton_tolerance = 1e-9,
                                           .sleeping = false});
    stepper->set_gravity(units::standard_gravity * Vec3(std::sin(angle), 0, -std::cos(angle)));
    return stepper;
}

// Of the block, whose vertices are the last ones.
Vec3 mean_of_block(std::span<const Vec3> values) {
    constexpr std::size_t vertices = 5 * 4 * 2;
    Vec3 sum = Vec3::Zero();
    for (const Vec3& x : values.last(vertices)) sum += x;
    return sum / static_cast<double>(vertices);
}

TEST(SelfFriction, ABlockSticksOnASlopeOfLessThanItsFriction) {
    const BodyDescription body = block_on_a_slab(mu, 0.3);
    const auto stepper = tilted(body, std::atan(0.9 * mu));
    for (int k = 0; k < 120; ++k) stepper->step(frame_s);
    const Vec3 before = mean_of_block(stepper->positions_mm());
    StepReport last;
    for (int k = 0; k < 60; ++k) last = stepper->step(frame_s);
    const double edge =
        build_body(body, ElementModel::corotated, ElementOrder::linear).mean_edge_mm;
    EXPECT_GT(last.self.contacts, 10);
    EXPECT_LT((mean_of_block(stepper->positions_mm()) - before).norm(), 1e-4 * edge);
}

TEST(SelfFriction, ABlockSlidesOnASteeperSlopeAsCoulombHasIt) {
    const BodyDescription body = block_on_a_slab(mu, 0.0);
    const double angle = std::atan(1.5 * mu);
    const auto stepper = tilted(body, angle);
    for (int k = 0; k < 4; ++k) stepper->step(frame_s);
    const double before = mean_of_block(stepper->velocities_mm_per_s()).x();
    for (int k = 0; k < 6; ++k) stepper->step(frame_s);
    const double expected = units::standard_gravity * (std::sin(angle) - mu * std::cos(angle));
    EXPECT_NEAR((mean_of_block(stepper->velocities_mm_per_s()).x() - before) / (6 * frame_s),
                expected, 0.01 * expected);
}

Vec3 momentum_of(const Body& body, std::span<const Vec3> velocities) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < velocities.size(); ++i) sum += body.mass_g[i] * velocities[i];
    return sum;
}

// Two bars that hit each other aslant: what one loses along the surface the other gets.
TEST(SelfFriction, AnObliqueImpactKeepsMomentumAndMakesNoEnergy) {
    for (const double speed_mm_per_s : {10.0, 100.0, 1e3, 1e4}) {
        double across = 0.0;
        for (const double friction : {0.0, mu}) {
            BodyDescription bars = crossed_bars(1.0);
            bars.material.damping_ratio = 0.0;
            bars.self->friction = friction;
            const Body body = build_body(bars, ElementModel::corotated, ElementOrder::linear);
            const auto stepper = make_cpu_stepper(bars, {.linear = {.energy_tolerance = 1e-10},
                                                         .newton_iterations = 8,
                                                         .newton_tolerance = 1e-9,
                                                         .sleeping = false});
            const std::size_t half = body.mass_g.size() / 2;
            std::vector<Vec3> v(body.mass_g.size(), Vec3::Zero());
            for (std::size_t i = half; i < v.size(); ++i)
                v[i] = Vec3(0.6, 0.1, -1) * speed_mm_per_s;
            stepper->set_state(body.rest_positions_mm, v);
            const Vec3 begin = momentum_of(body, v);
            double energy = stored_energy(stepper->energies());
            const int steps = static_cast<int>(std::ceil(3.0 / (speed_mm_per_s * frame_s))) + 10;
            for (int k = 0; k < steps; ++k) {
                const StepReport report = stepper->step(frame_s);
                const double left = stored_energy(report.energy);
                EXPECT_LE(left, energy * (1 + 1e-9)) << speed_mm_per_s << ", step " << k;
                energy = left;
                EXPECT_LT((momentum_of(body, stepper->velocities_mm_per_s()) - begin).norm(),
                          1e-10 * begin.norm())
                    << speed_mm_per_s << ", step " << k << ": " << report.message;
            }
            double lower = 0.0;
            for (std::size_t i = 0; i < half; ++i)
                lower += body.mass_g[i] * stepper->velocities_mm_per_s()[i].x();
            // At 10 mm/s they stay together either way.
            if (friction == 0.0) across = lower;
            if (friction > 0.0 && speed_mm_per_s > 10.0) {
                EXPECT_GT(lower, across + 0.2 * begin.x()) << speed_mm_per_s;
            }
        }
    }
}

// The upper bar is pulled down onto the lower one, along it, and let go.
struct Rub {
    BodyDescription body = crossed_bars(1.0);
    int held = 0;

    explicit Rub(double friction = mu) {
        for (const Vec3& x : body.mesh.vertices_mm)
            body.fixed.push_back(x.z() < 2.5 && std::abs(x.x()) > 11.9);
        body.self->friction = friction;
        const auto& x = body.mesh.vertices_mm;
        held = static_cast<int>(
            std::ranges::min_element(
                x, {}, [](const Vec3& at) { return (at - Vec3(0, 0, 7)).squaredNorm(); }) -
            x.begin());
    }
    void lead(Stepper& stepper, int k) const {
        Grab grab;
        grab.vertices[0] = held;
        grab.target_mm = body.mesh.vertices_mm[held] +
                         Vec3(0.1 * std::max(0, k - 30), 0, -0.06 * std::min(k + 1, 50));
        grab.stiffness_un_per_mm = 5e4;
        grab.force_limit_un = 2e5;
        stepper.set_grabs(k < 80 ? std::vector{grab} : std::vector<Grab>{});
    }
};

TEST(SelfFriction, TheLedgerCloses) {
    const Rub rub;
    const auto stepper = make_cpu_stepper(rub.body, {.linear = {.energy_tolerance = 1e-8}});
    double stored = 0.0, rubbed = 0.0;
    for (int k = 0; k < 110; ++k) {
        rub.lead(*stepper, k);
        const EnergyLedger ledger = stepper->step(frame_s).energy;
        const double open = std::abs(stored_energy(ledger) - stored - explained_change(ledger)) /
                            (stored + energy_handled(ledger) + 1e-300);
        EXPECT_LT(open, 1e-9) << "step " << k;
        EXPECT_GE(ledger.friction_loss, 0.0);
        rubbed += ledger.friction_loss;
        stored = stored_energy(ledger);
    }
    EXPECT_GT(rubbed, 100.0);
}

TEST(SelfFriction, TheSameCommandsGiveTheSameBitsForAnyNumberOfThreads) {
    const Rub rub;
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        const auto stepper = make_cpu_stepper(rub.body, {});
        std::uint64_t all = 0;
        for (int k = 0; k < 90; ++k) {
            rub.lead(*stepper, k);
            stepper->step(frame_s);
            all = 31 * all + stepper->state_hash();
        }
        hashes.push_back(all);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

// While the block slides, through bytes; also where the matrix that the solver holds is older than
// the last step.
TEST(SelfFriction, ARestoredStepperGoesOnToTheLastBit) {
    const BodyDescription body = block_on_a_slab(mu, 0.1);
    for (const LinearSolverKind solver : {LinearSolverKind::automatic, LinearSolverKind::skeleton})
        for (const int iterations : {1, 3}) {
            const auto made = [&] {
                auto stepper = make_cpu_stepper(
                    body, {.solver = solver, .newton_iterations = iterations, .sleeping = false});
                stepper->set_gravity(units::standard_gravity * Vec3(0.6, 0, -0.8));
                return stepper;
            };
            const auto first = made();
            for (int k = 0; k < 12; ++k) {
                const auto second = made();
                const StepperCheckpoint kept = checkpoint_from_bytes(to_bytes(first->checkpoint()));
                // Friction depends on where the step began of the matrix that a solver keeps.
                const bool keeps = solver == LinearSolverKind::skeleton && k > 0;
                EXPECT_EQ(kept.solver.began_mm.size(), keeps ? body.mesh.vertices_mm.size() : 0u);
                second->restore(kept);
                EXPECT_EQ(second->state_hash(), first->state_hash());
                second->step(frame_s);
                EXPECT_EQ(first->step(frame_s).self.contacts > 10, k > 0);
                EXPECT_EQ(second->state_hash(), first->state_hash())
                    << name_of(solver) << " with " << iterations << " at " << k;
            }
        }
}

// Dragged over the other and let go it stays lying there; without friction it slides off.
TEST(SelfFriction, WhatIsLeftLyingStaysAndSleeps) {
    for (const double friction : {0.0, mu}) {
        const Rub rub(friction);
        const auto stepper = make_cpu_stepper(rub.body, {});
        stepper->set_gravity(Vec3(0, 0, -units::standard_gravity));
        StepReport last;
        // What sticks still creeps, ever slower, until it is slow enough to sleep.
        const int longest = friction > 0.0 ? 3600 : 900;
        for (int k = 0; k < longest && !last.asleep; ++k) {
            if (k < 90) rub.lead(*stepper, k);
            last = stepper->step(frame_s);
        }
        EXPECT_EQ(last.asleep, friction > 0.0);
        EXPECT_EQ(last.self.contacts > 0, friction > 0.0);
        EXPECT_EQ(stepper->positions_mm()[rub.held].z() > 0.0, friction > 0.0);
    }
}

// Not touched, what could rub moves as what could not, to the last bit.
TEST(SelfFriction, WhereNothingTouchesTheBitsAreAsTheyWere) {
    std::vector<Vec3> expected;
    for (const double friction : {0.0, mu}) {
        BodyDescription bars = crossed_bars(8.0);
        bars.self->friction = friction;
        const auto stepper = make_cpu_stepper(bars, {});
        stepper->set_gravity(Vec3(0, 0, units::standard_gravity));
        for (int k = 0; k < 30; ++k) stepper->step(frame_s);
        if (friction == 0.0) expected = copy_of(stepper->positions_mm());
        EXPECT_TRUE(std::ranges::equal(expected, stepper->positions_mm()));
    }
}

TEST(SelfFriction, WhatIsNoCoefficientIsRefused) {
    for (const double friction : {-0.1, std::nan("")}) {
        BodyDescription bars = crossed_bars(1.0);
        bars.self->friction = friction;
        EXPECT_THROW(make_cpu_stepper(bars, {}), InputError) << friction;
    }
}

}  // namespace
}  // namespace hepatica
