// SPDX-License-Identifier: GPL-3.0-or-later
// A tool in the steps of a body: nothing passes through it at any speed, momentum and energy are
// accounted for, what is pressed comes to rest and sleeps, and all of it is the same bits again.
#include "core/deform/potentials/tool.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/resumed_play.h"
#include "tests/deform/support/tool_oracles.h"

namespace hepatica {
namespace {

using test::bar;
using test::copy_of;
using test::ends_inside;
using test::free_brick;
using test::least_gap;
using test::momentum;

Tool ball_at(const Vec3& centre_mm, double radius_mm = 3.0) {
    Tool tool = single_tool({.centre_mm = centre_mm, .radius_mm = radius_mm});
    tool.pad_mm = 0.4;
    tool.pressure_pa = 2e6;
    tool.friction = 0.3;
    return tool;
}

// At 0.01 to 100 m/s, led to and fro through the bar.
TEST(Tool, PassesThroughNothingAtAnySpeed) {
    const BodyDescription body = bar();
    const SurfacePatches surface(boundary_triangles(body.mesh));
    std::mt19937_64 random(4);
    const auto in = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
    };
    int touched = 0;
    for (const double speed_mm_per_s : {10.0, 100.0, 1e3, 1e4, 1e5}) {
        for (const bool capsule : {false, true}) {
            const auto stepper = make_cpu_stepper(body, {});
            Tool tool = ball_at(Vec3(30, 3, 14), in(0.3, 3.0));
            if (capsule) tool.parts[0].shape.half_axis_mm = Vec3(in(-4, 4), in(-4, 4), in(-2, 2));
            stepper->set_tool(tool);
            for (int k = 0; k < 60; ++k) {
                const Vec3 centre = stepper->tool()->parts[0].shape.centre_mm;
                const Vec3 goal(in(15, 45), in(-8, 14), k % 16 < 8 ? -10.0 : 16.0);
                const Vec3 way = goal - centre;
                stepper->lead_tool(centre +
                                   std::min(1.0, speed_mm_per_s * frame_s / way.norm()) * way);
                const StepReport report = stepper->step(frame_s);
                touched += report.tool.contacts > 0 ? 1 : 0;
                ASSERT_GT(least_gap(*stepper, surface), 0.0) << speed_mm_per_s << " mm/s, " << k;
                ASSERT_FALSE(ends_inside(*stepper, body.mesh));
                for (const Vec3& x : stepper->positions_mm()) ASSERT_TRUE(x.allFinite());
            }
        }
    }
    EXPECT_GT(touched, 50);
}

// A rod that is turned to and fro beside and against the bar, by up to a quarter of a turn a step.
TEST(Tool, TurnsThroughNothingAtAnySpeed) {
    const BodyDescription body = bar();
    const SurfacePatches surface(boundary_triangles(body.mesh));
    int touched = 0;
    for (const double turn_rad : {0.002, 0.02, 0.2, 1.5}) {
        const auto stepper = make_cpu_stepper(body, {});
        Tool tool = ball_at(Vec3(30, 3, 10.5), 1.5);
        tool.parts[0].shape.half_axis_mm = Vec3(0, 12, 0);
        stepper->set_tool(tool);
        for (int k = 0; k < 200; ++k) {
            if (k % 4 == 0)
                stepper->turn_tool(Vec3(k % 80 < 40 ? turn_rad : -turn_rad, 0.1 * turn_rad, 0));
            const StepReport report = stepper->step(frame_s);
            touched += report.tool.contacts > 0 ? 1 : 0;
            ASSERT_GT(least_gap(*stepper, surface), 0.0) << turn_rad << ", step " << k;
            ASSERT_FALSE(ends_inside(*stepper, body.mesh));
        }
        EXPECT_NEAR(stepper->tool()->parts[0].shape.half_axis_mm.norm(), 12.0, 1e-9);
    }
    EXPECT_GT(touched, 50);
}

// A free brick flies against a ball: it changes its momentum by what the ball gives it, never
// gains energy, and does not come through.
TEST(Tool, AnImpactExchangesMomentumAndMakesNoEnergy) {
    const BodyDescription description = free_brick();
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    const SurfacePatches surface(boundary_triangles(description.mesh));
    constexpr int most_iterates = 60;
    for (const double speed_mm_per_s : {10.0, 100.0, 1e3, 1e4}) {
        int converged = 0;
        const auto stepper = make_cpu_stepper(description, {.linear = {.energy_tolerance = 1e-10},
                                                            .newton_iterations = 30,
                                                            .newton_tolerance = 1e-12});
        Tool tool = ball_at(Vec3(6.3, 4.2, -5), 4.0);
        tool.friction = 0.0;
        stepper->set_tool(tool);
        stepper->set_state(description.mesh.vertices_mm,
                           std::vector<Vec3>(body.node_count(), Vec3(0, 0, -speed_mm_per_s)));
        double energy = stored_energy(stepper->energies());
        const Vec3 begin = momentum(*stepper, body);
        Vec3 before = begin;
        double exchanged = 0.0;
        for (int k = 0; k < 40; ++k) {
            const StepReport report = stepper->step(std::min(frame_s, 1.0 / speed_mm_per_s));
            const Vec3 now = momentum(*stepper, body);
            exchanged += report.tool.impulse_un_s.norm();
            if (!report.degraded && report.newton_iterations < most_iterates) {
                ++converged;
                EXPECT_LT((now - before + report.tool.impulse_un_s).norm(), 1e-6 * begin.norm())
                    << speed_mm_per_s << " mm/s, step " << k;
            }
            before = now;
            const double left = stored_energy(stepper->energies());
            EXPECT_LE(left, energy * (1 + 1e-9)) << speed_mm_per_s << " mm/s, step " << k;
            energy = left;
            EXPECT_GT(least_gap(*stepper, surface), 0.0);
        }
        EXPECT_GT(converged, 30) << speed_mm_per_s;
        EXPECT_GT(exchanged, 0.5 * begin.norm()) << speed_mm_per_s;
        EXPECT_GT(before.z(), 0.5 * begin.z());  // it does not go on as it came
    }
}

// On a ball of a kilometre, which is a plane here, gravity being turned instead.
struct Slope {
    double friction, ratio;  // of tan(angle) to friction
    double angle() const { return std::atan(ratio * friction); }
    std::unique_ptr<Stepper> stepper(const BodyDescription& block) const {
        auto made = make_cpu_stepper(block, {.linear = {.energy_tolerance = 1e-8},
                                             .newton_iterations = 8,
                                             .newton_tolerance = 1e-9,
                                             .sleeping = false});
        Tool ground = ball_at(Vec3(6, 4, -1e6 - 0.35), 1e6);
        ground.friction = friction;
        ground.pressure_pa = 1e5;
        made->set_tool(ground);
        made->set_gravity(units::standard_gravity * Vec3(std::sin(angle()), 0, -std::cos(angle())));
        return made;
    }
};

Vec3 middle(const Stepper& stepper) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& x : stepper.positions_mm()) sum += x;
    return sum / static_cast<double>(stepper.positions_mm().size());
}

BodyDescription flat_block() {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(12, 8, 3), {4, 3, 1});
    body.touchable = true;
    return body;
}

TEST(Tool, ABlockSticksOnASlopeOfLessThanItsFriction) {
    const BodyDescription block = flat_block();
    const auto stepper = Slope{0.4, 0.9}.stepper(block);
    for (int k = 0; k < 120; ++k) stepper->step(frame_s);
    const Vec3 before = middle(*stepper);
    for (int k = 0; k < 60; ++k) stepper->step(frame_s);
    const double edge =
        build_body(block, ElementModel::corotated, ElementOrder::linear).mean_edge_mm;
    EXPECT_LT((middle(*stepper) - before).norm(), 1e-4 * edge);
}

TEST(Tool, ABlockSlidesOnASteeperSlopeAsCoulombHasIt) {
    BodyDescription block = flat_block();
    block.material.damping_ratio = 0.0;  // which would brake flight, too
    const Slope slope{0.4, 1.5};
    const auto stepper = slope.stepper(block);
    for (int k = 0; k < 30; ++k) stepper->step(frame_s);
    const auto speed = [&] {
        double sum = 0.0;
        for (const Vec3& v : stepper->velocities_mm_per_s()) sum += v.x();
        return sum / static_cast<double>(stepper->velocities_mm_per_s().size());
    };
    const double before = speed();
    for (int k = 0; k < 60; ++k) stepper->step(frame_s);
    const double expected = units::standard_gravity *
                            (std::sin(slope.angle()) - slope.friction * std::cos(slope.angle()));
    EXPECT_NEAR((speed() - before) / 1.0, expected, 0.01 * expected);
}

// What a hand does: comes, presses, holds, leaves.
void play(Stepper& stepper, int k) {
    if (k == 0) stepper.set_tool(ball_at(Vec3(28, 2.5, 12)));
    if (k < 60) stepper.lead_tool(Vec3(28 + 0.05 * k, 2.5, 12 - 0.15 * k));
    if (k == 75) stepper.lead_tool(Vec3(31, 8, 3));
    if (k == 110) stepper.lead_tool(Vec3(30, 5, 30));
    if (k == 130) stepper.set_tool(std::nullopt);
}

TEST(Tool, TheSameCommandsGiveTheSameBitsForAnyNumberOfThreads) {
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        const auto stepper = make_cpu_stepper(bar(), {});
        std::uint64_t all = 0;
        for (int k = 0; k < 140; ++k) {
            play(*stepper, k);
            stepper->step(frame_s);
            all = 31 * all + stepper->state_hash();
        }
        hashes.push_back(all);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

class ToolCheckpointTest : public testing::TestWithParam<LinearSolverKind> {};

// In the middle of the pressing, through bytes.
TEST_P(ToolCheckpointTest, ARestoredStepperGoesOnToTheLastBit) {
    for (const bool region : {false, true}) {
        const auto make = [&]() -> std::unique_ptr<Stepper> {
            BodyDescription body = bar();
            if (!region) return make_cpu_stepper(body, {.solver = GetParam()});
            body.tether_pa_per_mm2 = 20.0;
            return make_live_stepper(body, {.solver = GetParam()});
        };
        const auto step = [&](Stepper& stepper, int k) {
            play(stepper, k);
            stepper.step(frame_s);
        };
        for (const int kept_at : {5, 50, 90})
            EXPECT_TRUE(test::expect_same_bits_from(kept_at, 140, make, step).tool) << region;
    }
}

INSTANTIATE_TEST_SUITE_P(Solvers, ToolCheckpointTest,
                         testing::Values(LinearSolverKind::automatic, LinearSolverKind::skeleton));

// Every field of a tool is written, read and hashed; without one the bytes are as they were.
TEST(ToolCheckpoint, EveryFieldCountsInTheHash) {
    const auto stepper = make_cpu_stepper(bar(), {});
    for (int k = 0; k < 70; ++k) {
        play(*stepper, k);
        stepper->step(frame_s);
    }
    const StepperCheckpoint kept = stepper->checkpoint();
    ASSERT_TRUE(kept.tool);
    using Change = void (*)(ToolCheckpoint&);
    std::vector<std::uint64_t> seen{hash_of(kept)};
    for (const Change change :
         {Change([](auto& c) { c.tool.parts[0].shape.centre_mm.x() += 1e-9; }),
          Change([](auto& c) { c.tool.parts[0].shape.half_axis_mm.x() += 1e-9; }),
          Change([](auto& c) { c.tool.parts[0].shape.radius_mm += 1e-9; }),
          Change([](auto& c) { c.tool.parts[0].opens.x() += 1e-9; }),
          Change([](auto& c) { c.tool.parts[0].led_by_mm.x() += 1e-9; }),
          Change([](auto& c) { c.tool.parts[0].led_half_axis_mm.x() += 1e-9; }),
          Change([](auto& c) { c.tool.parts.push_back(c.tool.parts[0]); }),
          Change([](auto& c) { c.tool.opening_mm += 1e-9; }),
          Change([](auto& c) { c.tool.turn_rad.x() += 1e-9; }),
          Change([](auto& c) { c.tool.opening_target_mm += 1e-9; }),
          Change([](auto& c) { c.tool.target_mm.x() += 1e-9; }),
          Change([](auto& c) { c.tool.led_over_s += 1e-9; }),
          Change([](auto& c) { c.tool.pad_mm += 1e-9; }),
          Change([](auto& c) { c.tool.pressure_pa += 1.0; }),
          Change([](auto& c) { c.tool.friction += 1e-9; }),
          Change([](auto& c) { c.tool.force_limit_un = 5.0; }),
          Change([](auto& c) { c.led = !c.led; }),
          Change([](auto& c) { c.last_load.force_un.x() += 1.0; }),
          Change([](auto& c) { c.last_load.torque_un_mm.x() += 1.0; }),
          Change([](auto& c) { c.last_load.impulse_un_s.x() += 1.0; }),
          Change([](auto& c) { c.last_load.contacts += 1; }),
          Change([](auto& c) { c.last_load.grip_un += 1.0; }),
          Change([](auto& c) { c.last_load.at_mm.x() += 1.0; }),
          Change([](auto& c) { c.last_load.touched.push_back(1 << 20); }),
          Change([](auto& c) { c.last_load.least_gap_mm += 1.0; }),
          Change([](auto& c) { c.last_contact += 1.0; })}) {
        StepperCheckpoint other = kept;
        change(*other.tool);
        EXPECT_EQ(hash_of(checkpoint_from_bytes(to_bytes(other))), hash_of(other));
        EXPECT_EQ(std::ranges::count(seen, hash_of(other)), 0);
        seen.push_back(hash_of(other));
    }
    StepperCheckpoint without = kept;
    without.tool.reset();
    without.solver.tool.reset();
    EXPECT_LT(to_bytes(without).size(), to_bytes(kept).size());
    EXPECT_FALSE(checkpoint_from_bytes(to_bytes(without)).tool);
}

// A body that may be touched and is not moves as one that may not, to the last bit.
TEST(Tool, WithoutOneTheBitsAreAsTheyWere) {
    std::uint64_t hash = 0;
    for (const bool touchable : {false, true}) {
        BodyDescription body = bar();
        body.touchable = touchable;
        const auto stepper = make_cpu_stepper(body, {});
        stepper->set_gravity(Vec3(0, 0, -units::standard_gravity));
        for (int k = 0; k < 30; ++k) stepper->step(frame_s);
        if (!touchable) hash = stepper->state_hash();
        EXPECT_EQ(stepper->state_hash(), hash);
    }
}

// Held against the bar for a minute.
TEST(Tool, WhatIsPressedComesToRestAndSleeps) {
    for (const bool region : {false, true}) {
        BodyDescription body = bar();
        if (region) body.tether_pa_per_mm2 = 20.0;
        std::unique_ptr<Stepper> stepper;
        if (region)
            stepper = make_live_stepper(body, {});
        else
            stepper = make_cpu_stepper(body, {});
        stepper->set_tool(ball_at(Vec3(30, 3, 12)));
        stepper->lead_tool(Vec3(30, 3, 8));
        for (int k = 0; k < 600; ++k) stepper->step(frame_s);
        const std::vector<Vec3> then = copy_of(stepper->positions_mm());
        const double energy = stored_energy(stepper->energies());
        StepReport last;
        for (int k = 0; k < 3600; ++k) last = stepper->step(frame_s);
        EXPECT_TRUE(last.asleep);
        EXPECT_GT(last.tool.contacts, 0);
        EXPECT_GT(last.tool.force_un.z(), 0.0);
        EXPECT_LE(stored_energy(stepper->energies()), energy * (1 + 1e-9));
        for (std::size_t v = 0; v < then.size(); ++v)
            EXPECT_LT((stepper->positions_mm()[v] - then[v]).norm(), 1e-3 * 3.0);
        // It wakes when the tool goes on.
        stepper->lead_tool(Vec3(30, 3, 7));
        EXPECT_FALSE(stepper->step(frame_s).asleep);
    }
}

TEST(Tool, TheLedgerOfWhatIsPressedAndRubbedCloses) {
    const auto stepper = make_cpu_stepper(bar(), {.linear = {.energy_tolerance = 1e-8}});
    double rubbed = 0.0, pressed = 0.0, stored = 0.0;
    for (int k = 0; k < 140; ++k) {
        play(*stepper, k);
        const StepReport report = stepper->step(frame_s);
        const EnergyLedger& ledger = report.energy;
        const double open = std::abs(stored_energy(ledger) - stored - explained_change(ledger)) /
                            (stored + energy_handled(ledger) + 1e-300);
        EXPECT_LT(open, 1e-9) << "step " << k;
        EXPECT_GE(ledger.friction_loss, 0.0);
        stored = stored_energy(ledger);
        rubbed += ledger.friction_loss;
        pressed = std::max(pressed, ledger.contact);
    }
    EXPECT_GT(rubbed, 0.0);
    EXPECT_GT(pressed, 0.0);
}

TEST(Tool, IsRefusedInTheBodyAndLeavesEverythingAsItWas) {
    const auto stepper = make_cpu_stepper(bar(), {});
    stepper->set_tool(ball_at(Vec3(30, 3, 12)));
    const std::uint64_t before = stepper->state_hash();
    EXPECT_THROW(stepper->set_tool(ball_at(Vec3(30, 3, 6))), InputError);
    EXPECT_THROW(stepper->lead_tool(Vec3(0, NAN, 0)), InputError);
    EXPECT_EQ(stepper->state_hash(), before);
    std::vector<Vec3> lifted = copy_of(stepper->positions_mm());
    for (Vec3& x : lifted) x.z() += 6.0;
    EXPECT_THROW(stepper->set_state(lifted, std::vector<Vec3>(lifted.size(), Vec3::Zero())),
                 InputError);
    EXPECT_EQ(stepper->state_hash(), before);
}

}  // namespace
}  // namespace hepatica
