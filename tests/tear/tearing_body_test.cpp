// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that tear: conservation over splits, fracture energy, where bars break, and what they go
// on from.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "core/deform/body/torn_body.h"
#include "core/deform/step/step_books.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/tearing.h"
#include "tests/tear/bars.h"

namespace hepatica {
namespace {

using test::bar;
using test::clamp_at_0;
using test::pull_of;
using test::spring;

// Pulls the bar until it is in two pieces; how many steps that took.
int pull_apart(Stepper& stepper, const BodyDescription& body, double length_mm, double step_mm) {
    for (int k = 1; k * step_mm <= 80.0; ++k) {
        stepper.set_grabs(pull_of(body, length_mm, step_mm * k));
        if (stepper.step(frame_s).tear.pieces > 1) return k;
    }
    return -1;
}

// Of the joints that have parted with all their corners, and of those alone.
std::vector<Vec3> torn_places(const Stepper& stepper) {
    std::vector<Vec3> places;
    const TornTopology& topology = stepper.tearing()->topology();
    for (std::size_t j = 0; j < topology.joints().size(); ++j) {
        const Joint& joint = topology.joints()[j];
        bool open = topology.parted(static_cast<int>(j));
        for (int k = 0; k < 3 && open; ++k) {
            const auto [a, b] = topology.sides(joint, k);
            open = a != b && (stepper.positions_mm()[a] - stepper.positions_mm()[b]).norm() >
                                 stepper.tearing()->law().softening().opening_mm;
        }
        if (open) places.push_back(joint.centre_mm);
    }
    return places;
}

struct Sums {
    double mass = 0.0, kinetic = 0.0;
    Vec3 momentum = Vec3::Zero(), angular = Vec3::Zero();
};

Sums sums_of(const BodyDescription& whole, const Stepper& stepper) {
    const Body body = build_body(torn(whole, torn_body_of(*stepper.tearing())),
                                 ElementModel::corotated, ElementOrder::linear);
    Sums sums;
    const BodyState state = stepper.state();
    sums.kinetic = kinetic_energy(body, state.velocities_mm_per_s);
    for (int i = 0; i < body.node_count(); ++i) {
        sums.mass += body.mass_g[i];
        sums.momentum += body.mass_g[i] * state.velocities_mm_per_s[i];
        sums.angular += body.mass_g[i] * state.positions_mm[i].cross(state.velocities_mm_per_s[i]);
    }
    return sums;
}

TEST(TearingBody, ASplitKeepsMassMomentumSpinAndEnergy) {
    const BodyDescription body = bar(Vec3(20, 4, 4), {10, 2, 2}, {});
    const auto stepper = make_cpu_stepper(body, {});
    std::mt19937 random(1);
    std::normal_distribution<double> gauss;
    BodyState state = stepper->state();
    for (std::size_t i = 0; i < state.positions_mm.size(); ++i) {
        state.positions_mm[i] += 0.05 * Vec3(gauss(random), gauss(random), gauss(random));
        state.velocities_mm_per_s[i] = 50.0 * Vec3(gauss(random), gauss(random), gauss(random)) +
                                       Vec3(0, 0, 4.0).cross(state.positions_mm[i]);
    }
    stepper->set_state(state.positions_mm, state.velocities_mm_per_s);
    const Sums before = sums_of(body, *stepper);
    const EnergyLedger energy = stepper->energies();
    for (const double x : {3.1, 7.3, 12.9, 17.2}) {
        stepper->cut(Vec3(x, -5, -5), Vec3(0.3, 14, 0), Vec3(-0.4, 0, 14));
        const Sums after = sums_of(body, *stepper);
        EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
        EXPECT_NEAR(after.kinetic, before.kinetic, 1e-12 * before.kinetic);
        EXPECT_LT((after.momentum - before.momentum).norm(), 1e-12 * before.momentum.norm());
        EXPECT_LT((after.angular - before.angular).norm(), 1e-12 * before.angular.norm());
        EXPECT_NEAR(stored_energy(stepper->energies()), stored_energy(energy),
                    1e-12 * stored_energy(energy));
    }
    EXPECT_EQ(stepper->tearing()->report().pieces, 5);
}

TEST(TearingBody, WithoutALimitHasTheBitsOfOneThatDoesNotTear) {
    BodyDescription body =
        bar(Vec3(20, 4, 4), {10, 2, 2}, {.strength_pa = 1e300, .fracture_energy_j_m2 = 1e300});
    clamp_at_0(body);
    body.tether_pa_per_mm2 = 20.0;
    BodyDescription other = body;
    other.tear.reset();
    const auto tears = make_live_stepper(body, {}), whole = make_live_stepper(other, {});
    for (int k = 0; k < 60; ++k) {
        for (Stepper* stepper :
             {static_cast<Stepper*>(tears.get()), static_cast<Stepper*>(whole.get())}) {
            stepper->set_grabs(pull_of(body, 20.0, 0.3 * k));
            stepper->step(frame_s);
        }
        ASSERT_TRUE(std::ranges::equal(tears->positions_mm(), whole->positions_mm())) << k;
    }
}

TEST(TearingBody, ANotchedBarBreaksAtItsNotch) {
    BodyDescription body = bar(Vec3(20, 4, 4), {15, 3, 3}, {.strength_pa = 1e5});
    clamp_at_0(body);
    const auto stepper = make_cpu_stepper(body, {});
    stepper->cut(Vec3(12.0, -1, -1), Vec3(0, 6, 0), Vec3(0, 0, 2.5));
    ASSERT_EQ(stepper->tearing()->report().pieces, 1);
    EXPECT_GT(pull_apart(*stepper, body, 20.0, 0.2), 0);
    for (const Vec3& place : torn_places(*stepper)) EXPECT_NEAR(place.x(), 12.0, 2.5);
}

TEST(TearingBody, AWholeBarBreaksAtItsClamp) {
    BodyDescription body = bar(Vec3(20, 4, 4), {15, 3, 3}, {.strength_pa = 1e5});
    clamp_at_0(body);
    const auto stepper = make_cpu_stepper(body, {});
    EXPECT_GT(pull_apart(*stepper, body, 20.0, 0.03), 0);
    for (const Vec3& place : torn_places(*stepper))
        EXPECT_GT(std::abs(place.x() - 10.0), 6.0);  // the pulled end is a clamp, too
}

// More is overloaded at once than may part in a step: the most loaded do, whatever their numbers.
TEST(TearingBody, OfTooManyTheMostLoadedPart) {
    BodyDescription body =
        bar(Vec3(12, 3, 3), {12, 3, 3}, {.strength_pa = 1.0, .bare_limit = true});
    std::mt19937 random(8);
    std::uniform_real_distribution<double> near(-0.1, 0.1);
    BodyState strained;
    for (const Vec3& x : body.mesh.vertices_mm) {
        strained.positions_mm.push_back(1.3 * x + Vec3(near(random), near(random), near(random)));
        strained.velocities_mm_per_s.push_back(Vec3::Zero());
    }
    const auto stepper = make_cpu_stepper(body, {});
    stepper->set_state(strained.positions_mm, strained.velocities_mm_per_s);
    stepper->step(1e-6);
    const TornTopology& topology = stepper->tearing()->topology();
    int parted = 0;
    for (std::size_t j = 0; j < topology.joints().size(); ++j)
        parted += topology.parted(static_cast<int>(j)) ? 1 : 0;
    EXPECT_EQ(parted, Tearing::most_joints);
    int of_the_first = 0;
    for (int j = 0; j < Tearing::most_joints; ++j) of_the_first += topology.parted(j) ? 1 : 0;
    EXPECT_LT(of_the_first, Tearing::most_joints / 2);
}

// Vertices and tetrahedra in another order.
TEST(TearingBody, TheSameFacesBreakHoweverTheyAreNumbered) {
    BodyDescription body = bar(Vec3(12, 4, 4), {6, 2, 2}, {.strength_pa = 1e5});
    std::mt19937 random(5);
    std::uniform_real_distribution<double> near(-0.2, 0.2);
    for (Vec3& x : body.mesh.vertices_mm)  // nothing is symmetric
        if (x.x() > 0.1 && x.x() < 11.9) x += Vec3(near(random), near(random), near(random));
    BodyDescription other = body;
    std::vector<int> number(body.mesh.vertices_mm.size());
    std::iota(number.begin(), number.end(), 0);
    std::ranges::shuffle(number, random);
    for (std::size_t v = 0; v < number.size(); ++v)
        other.mesh.vertices_mm[number[v]] = body.mesh.vertices_mm[v];
    for (auto& corners : other.mesh.tetrahedra)
        for (int& v : corners) v = number[v];
    std::ranges::shuffle(other.mesh.tetrahedra, random);
    clamp_at_0(body);
    clamp_at_0(other);
    std::vector<std::set<std::array<long, 3>>> torn;
    for (const BodyDescription& one : {body, other}) {
        const auto stepper = make_cpu_stepper(one, {});
        EXPECT_GT(pull_apart(*stepper, one, 12.0, 0.2), 0);
        auto& places = torn.emplace_back();
        for (const Vec3& p : torn_places(*stepper))
            places.insert(
                {std::lround(1e6 * p.x()), std::lround(1e6 * p.y()), std::lround(1e6 * p.z())});
    }
    EXPECT_GT(torn[0].size(), 4u);
    EXPECT_EQ(torn[0], torn[1]);
}

TEST(TearingBody, TheLedgerClosesWhileItTearsAndFractureOnlyTakes) {
    BodyDescription body = bar(Vec3(20, 4, 4), {10, 2, 2}, {.strength_pa = 1e5});
    clamp_at_0(body);
    StepperOptions options;
    options.audit = true;
    options.newton_iterations = 3;
    const auto stepper = make_cpu_stepper(body, options);
    double torn = 0.0, handled = 0.0;
    for (int k = 1; k <= 100; ++k) {
        stepper->set_grabs(pull_of(body, 20.0, 0.12 * k));
        const StepReport report = stepper->step(frame_s);
        EXPECT_LT(relative_imbalance(report.energy), 1e-5) << k;
        EXPECT_GE(report.energy.tear_loss, -1e-7 * handled) << k;
        handled += std::abs(report.energy.tool_work);
        torn += report.energy.tear_loss;
    }
    EXPECT_GT(torn, 164e3 * 16.0 * 0.9);  // a section of 4 x 4 mm at least
}

TEST(TearingBody, GoesOnToTheSameBitsFromTheMiddleOfATear) {
    BodyDescription body = bar(Vec3(20, 4, 4), {10, 2, 2}, {.strength_pa = 1e5});
    clamp_at_0(body);
    body.tether_pa_per_mm2 = 20.0;
    const auto one = make_live_stepper(body, {});
    one->weaken(std::vector{3, 4, 5, 40}, 0.5);
    const auto step = [&](Stepper& stepper, int k) {
        stepper.set_grabs(pull_of(body, 20.0, 0.1 * k));
        stepper.step(frame_s);
    };
    int middle = 1;
    for (; middle < 300 && one->tearing()->report().vertices_split < 20; ++middle)
        step(*one, middle);
    ASSERT_LT(middle, 300);
    const StepperCheckpoint kept = checkpoint_from_bytes(to_bytes(one->checkpoint()));
    const auto fresh = make_live_stepper(body, {}), used = make_live_stepper(body, {});
    for (int k = 1; k < 100; ++k) step(*used, k);  // torn further than the checkpoint
    EXPECT_GT(used->tearing()->report().vertices_split, 20);
    fresh->restore(kept);
    used->restore(kept);
    for (int k = middle; k < middle + 40; ++k) {
        for (Stepper* stepper : {one.get(), fresh.get(), used.get()}) step(*stepper, k);
        ASSERT_EQ(one->state_hash(), fresh->state_hash()) << k;
        ASSERT_EQ(one->state_hash(), used->state_hash()) << k;
    }
    EXPECT_GT(one->tearing()->report().vertices_split, 20);
}

TEST(TearingBody, AsleepReportsTheEnergyOfItsTiesAfterARestoreAsWell) {
    BodyDescription body = bar(Vec3(20, 4, 4), {10, 2, 2}, {.strength_pa = 1e5});
    clamp_at_0(body);
    const auto stepper = make_cpu_stepper(body, {});
    int k = 1;
    while (k < 300 && stepper->energies().cohesion == 0.0) {
        stepper->set_grabs(pull_of(body, 20.0, 0.1 * k++));
        stepper->step(frame_s);
    }
    StepReport report;
    for (int still = 0; still < 2000 && !report.asleep; ++still) report = stepper->step(frame_s);
    ASSERT_TRUE(report.asleep);
    EXPECT_GT(report.energy.cohesion, 0.0);
    EXPECT_EQ(report.energy.cohesion, stepper->energies().cohesion);
    const auto restored = make_cpu_stepper(body, {});
    restored->restore(stepper->checkpoint());
    const StepReport again = restored->step(frame_s);
    EXPECT_TRUE(again.asleep);
    EXPECT_EQ(again.energy.cohesion, report.energy.cohesion);
    EXPECT_EQ(stored_energy(again.energy), stored_energy(report.energy));
}

TEST(TearingBody, AnotherBackEndGoesOnWithTheTear) {
    BodyDescription body = bar(Vec3(20, 4, 4), {10, 2, 2}, {.strength_pa = 1e5});
    clamp_at_0(body);
    const auto stepper = make_cpu_stepper(body, {});
    ASSERT_GT(pull_apart(*stepper, body, 20.0, 0.2), 0);
    const TearReport before = stepper->tearing()->report();
    StepperOptions other;
    other.model = ElementModel::neohookean;
    other.solver = LinearSolverKind::block_jacobi;
    ASSERT_TRUE(stepper->set_options(other));
    EXPECT_EQ(stepper->tearing()->report(), before);
    for (int k = 0; k < 10; ++k) stepper->step(frame_s);
    EXPECT_EQ(stepper->tearing()->report().pieces, 2);
}

TEST(TearingBody, IsWholeAgainWhenItIsMadeSo) {
    BodyDescription body = bar(Vec3(20, 4, 4), {10, 2, 2}, {.strength_pa = 1e5});
    clamp_at_0(body);
    const auto stepper = make_cpu_stepper(body, {});
    ASSERT_GT(pull_apart(*stepper, body, 20.0, 0.2), 0);
    stepper->set_tear({});
    stepper->set_grabs({});
    const std::vector<Vec3> still(body.mesh.vertices_mm.size(), Vec3::Zero());
    stepper->set_state(body.mesh.vertices_mm, still);
    EXPECT_EQ(stepper->positions_mm().size(), body.mesh.vertices_mm.size());
    EXPECT_EQ(stepper->tearing()->report().vertices_split, 0);
    EXPECT_EQ(pull_apart(*stepper, body, 20.0, 0.2),
              pull_apart(*make_cpu_stepper(body, {}), body, 20.0, 0.2));
}

TEST(TearingBody, EachStopEndsTheTearAndNoneDoesNot) {
    TearLaw law{.strength_pa = 5e4};
    std::vector<TearReport> reports;
    for (const TearStop stop : {TearStop::none, TearStop::vertices, TearStop::entropy}) {
        law.stop = stop;
        law.vertex_budget = 10;
        law.entropy_budget_nats = 0.1;
        BodyDescription body = bar(Vec3(20, 4, 4), {10, 2, 2}, law);
        clamp_at_0(body);
        const auto stepper = make_cpu_stepper(body, {});
        for (int k = 1; k <= 120; ++k) {
            stepper->set_grabs(pull_of(body, 20.0, 0.1 * k));
            stepper->step(frame_s);
        }
        reports.push_back(stepper->tearing()->report());
    }
    EXPECT_FALSE(reports[0].stopped);
    EXPECT_TRUE(reports[1].stopped);
    EXPECT_TRUE(reports[2].stopped);
    EXPECT_GT(reports[1].vertices_split, 0);
    EXPECT_LE(reports[1].vertices_split, 10);
    EXPECT_GT(reports[0].joints_parted, reports[1].joints_parted);
    EXPECT_GT(reports[0].joints_parted, reports[2].joints_parted);
}

// Cut at rest, then strained: that alone produces nothing.
TEST(TearingBody, StrainAloneProducesNoEntropy) {
    TearLaw law{.strength_pa = 1e12, .stop = TearStop::entropy, .entropy_budget_nats = 0.2};
    BodyDescription body = bar(Vec3(20, 4, 4), {10, 2, 2}, law);
    clamp_at_0(body);
    const auto stepper = make_cpu_stepper(body, {});
    stepper->cut(Vec3(11, -1, -1), Vec3(0, 6, 0), Vec3(0, 0, 3));
    ASSERT_GT(stepper->tearing()->report().vertices_split, 0);
    for (int k = 1; k <= 40; ++k) {
        stepper->set_grabs(pull_of(body, 20.0, 0.05 * k));
        EXPECT_LT(stepper->step(frame_s).tear.entropy_produced_nats, 0.2) << k;
    }
    EXPECT_FALSE(stepper->tearing()->report().stopped);
}

// A body that is no brick of round numbers stores at rest what rounding leaves, everywhere alike.
TEST(TearingBody, WhatRoundingLeavesAtRestIsNoStrainedState) {
    TearLaw law{.strength_pa = 1e5};
    BodyDescription body = bar(Vec3(20, 4, 4), {10, 2, 2}, law);
    double phase = 0.0;
    for (Vec3& x : body.mesh.vertices_mm) {
        phase += 1.0;
        x += Vec3(71.3, -40.1, 113.7) + 0.1 * Vec3(std::sin(phase), std::cos(3 * phase), 0.3);
    }
    body.fixed.assign(body.mesh.vertices_mm.size(), 0);
    for (std::size_t v = 0; v < body.fixed.size(); ++v)
        body.fixed[v] = body.mesh.vertices_mm[v].x() < 72.0;
    const auto stepper = make_cpu_stepper(body, {});
    stepper->step(frame_s);
    stepper->cut(Vec3(82.3, -60, 100), Vec3(0, 60, 0), Vec3(0, 0, 17));
    ASSERT_GT(stepper->tearing()->report().vertices_split, 0);
    EXPECT_EQ(stepper->step(frame_s).tear.entropy_produced_nats, 0.0);
    EXPECT_EQ(stepper->tearing()->state().entropy_before_nats, -1.0) << "not known yet";
}

TEST(TearingBody, RefusesElementsAndSolversThatCannotTear) {
    const BodyDescription body = bar(Vec3(4, 2, 2), {2, 1, 1}, {});
    EXPECT_THROW(make_cpu_stepper(body, {.order = ElementOrder::quadratic}), InputError);
    EXPECT_THROW(make_cpu_stepper(body, {.solver = LinearSolverKind::skeleton}), InputError);
    BodyDescription wrong = body;
    wrong.tear->strength_pa = 0.0;
    EXPECT_THROW(make_cpu_stepper(wrong, {}), InputError);
    const auto stepper = make_cpu_stepper(body, {});
    EXPECT_THROW(stepper->weaken(std::vector{-1}, 0.5), InputError);
    EXPECT_THROW(stepper->weaken(std::vector{0}, -0.5), InputError);
}

// Every face at once, while it flies and spins.
TEST(TearingBody, FallsToSingleTetrahedra) {
    BodyDescription body = bar(Vec3(6, 4, 4), {3, 2, 2}, {.strength_pa = 1e-3, .bare_limit = true});
    const auto stepper = make_cpu_stepper(body, {});
    BodyState state = stepper->state();
    for (std::size_t i = 0; i < state.positions_mm.size(); ++i)
        state.velocities_mm_per_s[i] =
            Vec3(0, 0, 10.0).cross(state.positions_mm[i]) + 20.0 * state.positions_mm[i];
    stepper->set_state(state.positions_mm, state.velocities_mm_per_s);
    for (int k = 0; k < 10; ++k) stepper->step(frame_s);
    EXPECT_EQ(stepper->tearing()->report().pieces, static_cast<int>(body.mesh.tetrahedra.size()));
    for (const Vec3& x : stepper->positions_mm()) EXPECT_TRUE(x.allFinite());
}

}  // namespace
}  // namespace hepatica
