// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of a body in its steps: they never pass through each other, momentum and energy are
// accounted for, what rests on another sleeps, and all of it is the same bits again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/frame_time.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/crossing_triangles.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/resumed_play.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

using test::copy_of;
using test::crossed_bars;

Vec3 momentum(const Body& body, const Stepper& stepper) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < body.mass_g.size(); ++i)
        sum += body.mass_g[i] * stepper.velocities_mm_per_s()[i];
    return sum;
}

std::size_t crossings(const BodyDescription& body, const Stepper& stepper) {
    return crossing_triangles(boundary_triangles(body.mesh), stepper.positions_mm()).size();
}

TEST(SelfTouch, AnImpactKeepsMomentumAndMakesNoEnergy) {
    BodyDescription bars = crossed_bars(1.0);
    bars.material.damping_ratio = 0.0;
    const Body body = build_body(bars, ElementModel::corotated, ElementOrder::linear);
    const std::size_t half = body.mass_g.size() / 2;
    for (const double speed_mm_per_s : {10.0, 100.0, 1000.0, 10000.0}) {
        for (const int iterations : {1, 8}) {
            const auto stepper = make_cpu_stepper(bars, {.linear = {.energy_tolerance = 1e-10},
                                                         .newton_iterations = iterations,
                                                         .newton_tolerance = 1e-9,
                                                         .sleeping = false});
            std::vector<Vec3> v(body.mass_g.size(), Vec3::Zero());
            for (std::size_t i = half; i < v.size(); ++i)
                v[i] = Vec3(0.1, 0.05, -1) * speed_mm_per_s;
            stepper->set_state(body.rest_positions_mm, v);
            const Vec3 begin = momentum(body, *stepper);
            double energy = stored_energy(stepper->energies());
            int touched = 0;
            const int steps = static_cast<int>(std::ceil(3.0 / (speed_mm_per_s * frame_s))) + 10;
            for (int k = 0; k < steps; ++k) {
                const StepReport report = stepper->step(frame_s);
                touched += report.self.contacts > 0 ? 1 : 0;
                const double left = stored_energy(report.energy);
                EXPECT_LE(left, energy * (1 + 1e-9)) << speed_mm_per_s << " step " << k;
                energy = left;
                EXPECT_LT((momentum(body, *stepper) - begin).norm(), 1e-10 * begin.norm())
                    << speed_mm_per_s << " step " << k << " of " << iterations << ": "
                    << report.message << ", " << report.self.contacts << " contacts";
            }
            EXPECT_GT(touched, 0) << speed_mm_per_s;
            // The upper one has given way.
            Vec3 upper = Vec3::Zero();
            for (std::size_t i = half; i < v.size(); ++i)
                upper += body.mass_g[i] * stepper->velocities_mm_per_s()[i];
            EXPECT_GT(upper.z(), 0.7 * begin.z()) << speed_mm_per_s;
            EXPECT_EQ(crossings(bars, *stepper), 0u) << speed_mm_per_s;
        }
    }
}

int vertex_near(const BodyDescription& body, const Vec3& point_mm) {
    const auto& x = body.mesh.vertices_mm;
    const auto nearest = std::ranges::min_element(
        x, {}, [&](const Vec3& at) { return (at - point_mm).squaredNorm(); });
    return static_cast<int>(nearest - x.begin());
}

Grab pull(int vertex, const Vec3& target_mm, double strength_un = 2e5) {
    Grab grab;
    grab.vertices[0] = vertex;
    grab.target_mm = target_mm;
    grab.stiffness_un_per_mm = 5e4;
    grab.force_limit_un = strength_un;
    return grab;
}

// The lower bar is clamped at its ends; the upper one is dragged through it by both ends.
BodyDescription clamped_below(double gap_mm) {
    BodyDescription body = crossed_bars(gap_mm);
    for (const Vec3& x : body.mesh.vertices_mm)
        body.fixed.push_back(x.z() < 2.0 + 0.5 * gap_mm && std::abs(x.x()) > 11.9);
    return body;
}

TEST(SelfTouch, WhatIsPulledOntoAnotherDoesNotPassIt) {
    for (const double speed_mm_per_s : {30.0, 600.0, 10000.0}) {
        const BodyDescription body = clamped_below(1.0);
        const auto stepper = make_cpu_stepper(body, {});
        const Vec3 end = test::about_z(1.4) * Vec3(12, 0, 0);
        const int first = vertex_near(body, Vec3(0, 0, 5) + end);
        const int second = vertex_near(body, Vec3(0, 0, 5) - end);
        int touched = 0;
        for (int k = 0; k < 90; ++k) {
            const Vec3 down(0, 0, -std::min(20.0, speed_mm_per_s * frame_s * k));
            stepper->set_grabs(std::vector{pull(first, body.mesh.vertices_mm[first] + down),
                                           pull(second, body.mesh.vertices_mm[second] + down)});
            touched += stepper->step(frame_s).self.contacts > 0 ? 1 : 0;
            if (k % 5 == 4) {
                ASSERT_EQ(crossings(body, *stepper), 0u) << speed_mm_per_s << " step " << k;
            }
        }
        EXPECT_GT(touched, 30) << speed_mm_per_s;
        // The ends hang below the lower bar, whose middle is pressed down by the other's.
        EXPECT_LT(stepper->positions_mm()[first].z(), -4.0);
        EXPECT_LT(stepper->positions_mm()[vertex_near(body, Vec3(0, 0, 2))].z(), 1.9);
    }
}

// A bar of 1.2 mm along a trefoil that is open at one place.
BodyDescription open_trefoil() {
    const auto at = [](double t) -> Vec3 {
        return 4.0 * Vec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                          -std::sin(3 * t));
    };
    BodyDescription body;
    constexpr int cells = 90;
    constexpr double width = 1.2, begin = 0.25, end = 2 * M_PI - 0.25;
    body.mesh = kuhn_brick(Vec3(cells, width, width), {cells, 1, 1});
    std::vector<Vec3> middle(cells + 1), across(cells + 1), along(cells + 1);
    for (int k = 0; k <= cells; ++k) {
        const double t = begin + (end - begin) * k / cells;
        middle[k] = at(t);
        along[k] = (at(t + 1e-4) - at(t - 1e-4)).normalized();
        const Vec3 before = k == 0 ? Vec3(0.3, 0.2, 0.9) : across[k - 1];
        across[k] = (before - before.dot(along[k]) * along[k]).normalized();
    }
    for (Vec3& x : body.mesh.vertices_mm) {
        const int k = static_cast<int>(std::lround(x.x()));
        x = middle[k] + (x.y() - 0.5 * width) * across[k] +
            (x.z() - 0.5 * width) * along[k].cross(across[k]);
    }
    body.self.emplace();
    return body;
}

// Its ends are pulled apart; no crossing at any look, so it is the same knot.
TEST(SelfTouch, AKnotPulledTightStaysAKnot) {
    const BodyDescription body = open_trefoil();
    ASSERT_EQ(crossing_triangles(boundary_triangles(body.mesh), body.mesh.vertices_mm).size(), 0u);
    const auto stepper = make_cpu_stepper(body, {});
    const int first = 0, last = 90;
    const Vec3 apart = (body.mesh.vertices_mm[last] - body.mesh.vertices_mm[first]).normalized();
    std::size_t most = 0;
    for (int k = 0; k < 240; ++k) {
        const double by = std::min(40.0, 0.25 * k);
        stepper->set_grabs(std::vector{pull(first, body.mesh.vertices_mm[first] - by * apart, 2e4),
                                       pull(last, body.mesh.vertices_mm[last] + by * apart, 2e4)});
        const StepReport report = stepper->step(frame_s);
        most = std::max(most, static_cast<std::size_t>(report.self.contacts));
        if (k % 12 == 11) {
            ASSERT_EQ(crossings(body, *stepper), 0u) << "step " << k;
        }
    }
    EXPECT_GT(most, 3u);
    EXPECT_GT((stepper->positions_mm()[last] - stepper->positions_mm()[first]).norm(), 30.0);
}

TEST(SelfTouch, WhatRestsOnAnotherComesToRestAndSleeps) {
    for (const bool region : {false, true}) {
        const BodyDescription body = clamped_below(0.2);
        std::unique_ptr<Stepper> stepper;
        if (region)
            stepper = make_live_stepper(body, {});
        else
            stepper = make_cpu_stepper(body, {});
        stepper->set_gravity(Vec3(0, 0, -units::standard_gravity));
        for (int k = 0; k < 1200; ++k) stepper->step(frame_s);
        const std::vector<Vec3> then = copy_of(stepper->positions_mm());
        const EnergyLedger energies = stepper->energies();
        StepReport last;
        for (int k = 0; k < 3600; ++k) last = stepper->step(frame_s);
        EXPECT_TRUE(last.asleep) << region;
        EXPECT_GT(last.self.contacts, 0) << region;
        EXPECT_LE(stored_energy(stepper->energies()), stored_energy(energies) * (1 + 1e-9));
        double moved = 0.0;
        for (std::size_t v = 0; v < then.size(); ++v)
            moved = std::max(moved, (stepper->positions_mm()[v] - then[v]).norm());
        EXPECT_LT(moved, 1e-3 * 2.0) << region;
        EXPECT_EQ(crossings(body, *stepper), 0u);
        // What lies on the other wakes with it.
        stepper->set_grabs(std::vector{pull(vertex_near(body, Vec3(0, 0, 6.2)), Vec3(0, 0, 16))});
        EXPECT_FALSE(stepper->step(frame_s).asleep);
    }
}

// A bar that lies across another and half in it, and one that is buried in it with an end. Pulled
// out and let go onto it again, both stay out.
TEST(SelfTouch, WhatOverlapsAtRestComesApartAndThenCounts) {
    for (const double lift_mm : {2.2, 0.0}) {
        BodyDescription body;
        test::add_mesh(test::bar_at(Vec3(24, 6, 6), {8, 2, 2}, Mat3::Identity(), Vec3::Zero()),
                       body.mesh);
        test::add_mesh(test::bar_at(Vec3(2, 2, 12), {1, 1, 6}, test::about_z(0.4),
                                    Vec3(0.1, 0.2, 5.5 + lift_mm)),
                       body.mesh);
        for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(std::abs(x.x()) > 11.9);
        body.self.emplace();
        const std::size_t before =
            crossing_triangles(boundary_triangles(body.mesh), body.mesh.vertices_mm).size();
        ASSERT_GT(before, 0u);
        const auto stepper = make_cpu_stepper(body, {});
        // Nothing pushes it apart.
        for (int k = 0; k < 30; ++k) EXPECT_EQ(stepper->step(frame_s).self.contacts, 0);
        for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v)
            EXPECT_LT((stepper->positions_mm()[v] - body.mesh.vertices_mm[v]).norm(), 1e-9);
        const int top = vertex_near(body, Vec3(0, 0, 12));
        const auto lead = [&](double z, int steps) {
            int touched = 0;
            for (int k = 0; k < steps; ++k) {
                Vec3 to = body.mesh.vertices_mm[top];
                to.z() += z;
                stepper->set_grabs(std::vector{pull(top, to, 3e4)});
                touched += stepper->step(frame_s).self.contacts > 0 ? 1 : 0;
            }
            return touched;
        };
        lead(10.0, 120);
        EXPECT_EQ(crossings(body, *stepper), 0u) << lift_mm;
        EXPECT_GT(lead(-8.0, 120), 10) << lift_mm;
        EXPECT_EQ(crossings(body, *stepper), 0u) << lift_mm;
    }
}

// The upper bar is pulled down onto the lower one and let go.
void play(Stepper& stepper, const BodyDescription& body, int k) {
    const int vertex = vertex_near(body, Vec3(0, 0, 7));
    if (k < 60)
        stepper.set_grabs(std::vector{
            pull(vertex, body.mesh.vertices_mm[vertex] + Vec3(0.02, 0, -0.06) * (k + 1))});
    if (k == 60) stepper.set_grabs({});
}

TEST(SelfTouch, TheSameCommandsGiveTheSameBitsForAnyNumberOfThreads) {
    const BodyDescription body = clamped_below(1.0);
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        const auto stepper = make_cpu_stepper(body, {});
        std::uint64_t all = 0;
        int touched = 0;
        for (int k = 0; k < 90; ++k) {
            play(*stepper, body, k);
            touched += stepper->step(frame_s).self.contacts;
            all = 31 * all + stepper->state_hash();
        }
        EXPECT_GT(touched, 100);
        hashes.push_back(all);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

class SelfTouchCheckpointTest : public testing::TestWithParam<LinearSolverKind> {};

// In the middle of contact, through bytes.
TEST_P(SelfTouchCheckpointTest, ARestoredStepperGoesOnToTheLastBit) {
    for (const bool region : {false, true}) {
        BodyDescription body = clamped_below(1.0);
        if (region) body.tether_pa_per_mm2 = 20.0;
        const auto make = [&]() -> std::unique_ptr<Stepper> {
            if (region) return make_live_stepper(body, {.solver = GetParam()});
            return make_cpu_stepper(body, {.solver = GetParam()});
        };
        const auto step = [&](Stepper& stepper, int k) {
            play(stepper, body, k);
            stepper.step(frame_s);
        };
        for (const int kept_at : {5, 40, 70})
            EXPECT_TRUE(test::expect_same_bits_from(kept_at, 90, make, step).self) << region;
    }
}

INSTANTIATE_TEST_SUITE_P(Solvers, SelfTouchCheckpointTest,
                         testing::Values(LinearSolverKind::automatic, LinearSolverKind::skeleton));

// Surfaces that may touch and do not: the same motion to the last bit.
TEST(SelfTouch, WhereNothingTouchesTheBitsAreAsTheyWere) {
    std::vector<Vec3> expected;
    for (const bool self : {false, true}) {
        BodyDescription body = clamped_below(8.0);
        if (!self) body.self.reset();
        const auto stepper = make_cpu_stepper(body, {});
        stepper->set_gravity(Vec3(0, 0, units::standard_gravity));
        for (int k = 0; k < 30; ++k) stepper->step(frame_s);
        if (!self) expected = copy_of(stepper->positions_mm());
        EXPECT_TRUE(std::ranges::equal(expected, stepper->positions_mm()));
        EXPECT_EQ(stepper->checkpoint().self.has_value(), self);
    }
}

TEST(SelfTouch, TheLedgerCloses) {
    const BodyDescription body = clamped_below(1.0);
    const auto stepper = make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-8}});
    double pressed = 0.0, stored = 0.0;
    for (int k = 0; k < 90; ++k) {
        play(*stepper, body, k);
        const EnergyLedger ledger = stepper->step(frame_s).energy;
        const double open = std::abs(stored_energy(ledger) - stored - explained_change(ledger)) /
                            (stored + energy_handled(ledger) + 1e-300);
        EXPECT_LT(open, 1e-9) << "step " << k;
        stored = stored_energy(ledger);
        pressed = std::max(pressed, ledger.contact);
    }
    EXPECT_GT(pressed, 0.0);
}

}  // namespace
}  // namespace hepatica
