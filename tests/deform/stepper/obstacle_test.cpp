// SPDX-License-Identifier: GPL-3.0-or-later
// A body beside obstacles in its steps: it enters none and leaves none that holds it, at any speed;
// momentum, weight, friction and energy are accounted for; what rests sleeps; what overlapped at
// rest is not pushed; and all of it is the same bits again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/crossing_triangles.h"
#include "tests/deform/support/obstacle_shapes.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/resumed_play.h"
#include "tests/deform/support/tool_oracles.h"

namespace hepatica {
namespace {

using test::ball_surface;
using test::box_surface;
using test::copy_of;
using test::momentum;
using test::one_obstacle;
using test::points_inside;

// Pairs of triangles of the body and of obstacles that cross, by exact predicates.
int crossings_with_obstacles(const BodyDescription& body, const Stepper& stepper) {
    const WithObstacles all =
        with_obstacles(*body.obstacles, stepper.positions_mm(), boundary_triangles(body.mesh));
    const auto of_body = static_cast<int>(boundary_triangles(body.mesh).size());
    const auto pairs = crossing_triangles(all.triangles, all.positions_mm);
    return static_cast<int>(std::ranges::count_if(
        pairs, [&](const auto& pair) { return pair[0] < of_body && pair[1] >= of_body; }));
}

const TriangleMesh& surface_of_first(const BodyDescription& body) {
    return body.obstacles->all.front().surface;
}

int nearest_vertex(const BodyDescription& body, const Vec3& point_mm) {
    const auto& x = body.mesh.vertices_mm;
    return static_cast<int>(
        std::ranges::min_element(x, {},
                                 [&](const Vec3& at) { return (at - point_mm).squaredNorm(); }) -
        x.begin());
}

Grab hand_at(int vertex, const Vec3& target_mm, double strength_un = 2e5) {
    Grab grab;
    grab.vertices[0] = vertex;
    grab.target_mm = target_mm;
    grab.stiffness_un_per_mm = 5e4;
    grab.force_limit_un = strength_un;
    return grab;
}

// The bar of tests of tools, with a tumour of 4 mm a little above its middle.
BodyDescription bar_below_a_ball() {
    BodyDescription body = test::bar();
    body.touchable = false;
    body.obstacles = one_obstacle(ball_surface(Vec3(30.3, 3.2, 11.5), 4.0));
    return body;
}

// Pulled through where the tumour is and beyond it, and back.
TEST(Obstacle, WhatIsPulledAgainstATumourDoesNotEnter) {
    const BodyDescription body = bar_below_a_ball();
    const int held = nearest_vertex(body, Vec3(30, 3, 6));
    for (const double speed_mm_per_s : {10.0, 100.0, 1e3, 1e4}) {
        const auto stepper = make_cpu_stepper(body, {});
        int touched = 0;
        const int steps = speed_mm_per_s < 100.0 ? 180 : 90;
        for (int k = 0; k < steps; ++k) {
            const double up = std::min(25.0, speed_mm_per_s * frame_s * (k + 1));
            const Vec3 to = body.mesh.vertices_mm[held] + Vec3(0.1 * up, 0, up);
            stepper->set_grabs(std::vector{hand_at(held, to)});
            const StepReport report = stepper->step(frame_s);
            touched += report.obstacles.touch.contacts > 0 ? 1 : 0;
            EXPECT_GT(report.obstacles.touch.least_gap_mm, 0.0);
            ASSERT_EQ(points_inside(surface_of_first(body), stepper->positions_mm()), 0)
                << speed_mm_per_s << " mm/s, step " << k;
            ASSERT_EQ(crossings_with_obstacles(body, *stepper), 0)
                << speed_mm_per_s << " mm/s, step " << k;
        }
        EXPECT_GT(touched, 20) << speed_mm_per_s;
        EXPECT_GT(stepper->positions_mm()[held].z(), 7.0);
    }
}

// A bar inside of a box is pulled out through its wall, a corner first.
TEST(Obstacle, WhatLiesInAShellDoesNotLeaveIt) {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(24, 4, 4), {12, 2, 2});
    body.obstacles = one_obstacle(box_surface(Vec3(-3, -4, -4), Vec3(30, 12, 12), {5, 2, 2}), 0.2,
                                  SurfaceKind::shell);
    const int end = nearest_vertex(body, Vec3(24, 4, 4));
    for (const double speed_mm_per_s : {30.0, 600.0, 1e4}) {
        const auto stepper = make_cpu_stepper(body, {});
        int touched = 0;
        for (int k = 0; k < 90; ++k) {
            const double by = std::min(25.0, speed_mm_per_s * frame_s * (k + 1));
            const Vec3 to = body.mesh.vertices_mm[end] + by * Vec3(0.5, 0.7, 0.6);
            stepper->set_grabs(std::vector{hand_at(end, to)});
            touched += stepper->step(frame_s).obstacles.touch.contacts > 0 ? 1 : 0;
            ASSERT_EQ(points_inside(surface_of_first(body), stepper->positions_mm()),
                      static_cast<int>(body.mesh.vertices_mm.size()))
                << speed_mm_per_s << " mm/s, step " << k;
            ASSERT_EQ(crossings_with_obstacles(body, *stepper), 0);
        }
        EXPECT_GT(touched, 20) << speed_mm_per_s;
    }
}

// Free, without friction and damping: what it loses is what the tumour gets.
TEST(Obstacle, AnImpactChangesMomentumByTheImpulseAndMakesNoEnergy) {
    BodyDescription brick = test::free_brick();
    brick.touchable = false;
    brick.obstacles = one_obstacle(ball_surface(Vec3(6.3, 4.2, -5), 4.0), 0.0);
    const Body body = build_body(brick, ElementModel::corotated, ElementOrder::linear);
    for (const double speed_mm_per_s : {10.0, 100.0, 1e3, 1e4}) {
        const auto stepper = make_cpu_stepper(brick, {.linear = {.energy_tolerance = 1e-10},
                                                      .newton_iterations = 30,
                                                      .newton_tolerance = 1e-12});
        stepper->set_state(brick.mesh.vertices_mm,
                           std::vector<Vec3>(body.node_count(), Vec3(0, 0, -speed_mm_per_s)));
        double energy = stored_energy(stepper->energies());
        const Vec3 begin = momentum(*stepper, body);
        Vec3 before = begin;
        double exchanged = 0.0;
        int converged = 0;
        for (int k = 0; k < 40; ++k) {
            const StepReport report = stepper->step(std::min(frame_s, 1.0 / speed_mm_per_s));
            const Vec3 now = momentum(*stepper, body);
            exchanged += report.obstacles.impulse_un_s.norm();
            if (!report.degraded && report.newton_iterations < 60) {
                ++converged;
                EXPECT_LT((now - before + report.obstacles.impulse_un_s).norm(),
                          1e-6 * begin.norm())
                    << speed_mm_per_s << " mm/s, step " << k;
            }
            before = now;
            const double left = stored_energy(stepper->energies());
            EXPECT_LE(left, energy * (1 + 1e-9)) << speed_mm_per_s << " mm/s, step " << k;
            energy = left;
            ASSERT_EQ(crossings_with_obstacles(brick, *stepper), 0);
        }
        EXPECT_GT(converged, 30) << speed_mm_per_s;
        EXPECT_GT(exchanged, 0.5 * begin.norm()) << speed_mm_per_s;
        EXPECT_GT(before.z(), 0.5 * begin.z());  // it does not go on as it came
    }
}

// A block on a box, a little above it at first.
BodyDescription block_on_a_box(double friction, double damping = 0.3) {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(12, 8, 3), {4, 3, 1});
    body.material.damping_ratio = damping;
    body.obstacles = one_obstacle(
        box_surface(Vec3(-2000, -20, -10.3), Vec3(6000, 50, 10), {750, 6, 1}), friction);
    return body;
}

TEST(Obstacle, WhatRestsOnOneWeighsOnItAndSleeps) {
    const BodyDescription block = block_on_a_box(0.3);
    const Body body = build_body(block, ElementModel::corotated, ElementOrder::linear);
    double mass_g = 0.0;
    for (const double m : body.mass_g) mass_g += m;
    const double weight_un = mass_g * units::standard_gravity;
    for (const bool region : {false, true}) {
        std::unique_ptr<Stepper> stepper;
        if (region)
            stepper = make_live_stepper(block, {});
        else
            stepper = make_cpu_stepper(block, {});
        stepper->set_gravity(Vec3(0, 0, -units::standard_gravity));
        StepReport last;
        for (int k = 0; k < 1200 && !last.asleep; ++k) last = stepper->step(frame_s);
        EXPECT_TRUE(last.asleep) << region;
        EXPECT_GT(last.obstacles.touch.contacts, 3) << region;
        // A part that is slow enough is frozen in the region as it is, before it is in balance.
        const double exact = region ? 0.3 : 0.01;
        EXPECT_NEAR(last.obstacles.force_un.z(), -weight_un, exact * weight_un) << region;
        EXPECT_LT(last.obstacles.force_un.head<2>().norm(), exact * weight_un) << region;
        const std::vector<Vec3> then = copy_of(stepper->positions_mm());
        for (int k = 0; k < 600; ++k) EXPECT_TRUE(stepper->step(frame_s).asleep);
        EXPECT_TRUE(std::ranges::equal(then, stepper->positions_mm()));
        // It wakes and goes where it is pulled.
        stepper->set_grabs(std::vector{hand_at(0, then[0] + Vec3(0, 0, 5))});
        EXPECT_FALSE(stepper->step(frame_s).asleep);
    }
}

std::unique_ptr<Stepper> on_a_slope(const BodyDescription& block, double angle) {
    auto stepper = make_cpu_stepper(block, {.linear = {.energy_tolerance = 1e-8},
                                            .newton_iterations = 8,
                                            .newton_tolerance = 1e-9,
                                            .sleeping = false});
    stepper->set_gravity(units::standard_gravity * Vec3(std::sin(angle), 0, -std::cos(angle)));
    return stepper;
}

Vec3 mean_of(std::span<const Vec3> values) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& x : values) sum += x;
    return sum / static_cast<double>(values.size());
}

TEST(Obstacle, ABlockSticksOnASlopeOfLessThanItsFriction) {
    const BodyDescription block = block_on_a_box(0.4);
    const auto stepper = on_a_slope(block, std::atan(0.9 * 0.4));
    for (int k = 0; k < 120; ++k) stepper->step(frame_s);
    const Vec3 before = mean_of(stepper->positions_mm());
    for (int k = 0; k < 60; ++k) stepper->step(frame_s);
    const double edge =
        build_body(block, ElementModel::corotated, ElementOrder::linear).mean_edge_mm;
    EXPECT_LT((mean_of(stepper->positions_mm()) - before).norm(), 1e-4 * edge);
}

TEST(Obstacle, ABlockSlidesOnASteeperSlopeAsCoulombHasIt) {
    const BodyDescription block = block_on_a_box(0.4, 0.0);
    const double angle = std::atan(1.5 * 0.4);
    const auto stepper = on_a_slope(block, angle);
    for (int k = 0; k < 30; ++k) stepper->step(frame_s);
    const double before = mean_of(stepper->velocities_mm_per_s()).x();
    for (int k = 0; k < 60; ++k) stepper->step(frame_s);
    const double expected = units::standard_gravity * (std::sin(angle) - 0.4 * std::cos(angle));
    EXPECT_NEAR(mean_of(stepper->velocities_mm_per_s()).x() - before, expected, 0.01 * expected);
}

// Obstacles that are never touched: the same motion to the last bit.
TEST(Obstacle, WhereNothingTouchesTheBitsAreAsTheyWere) {
    std::vector<Vec3> expected;
    for (const bool there : {false, true}) {
        BodyDescription body = bar_below_a_ball();
        if (!there) body.obstacles.reset();
        const auto stepper = make_cpu_stepper(body, {});
        stepper->set_gravity(Vec3(0, 0, -units::standard_gravity));
        for (int k = 0; k < 60; ++k) stepper->step(frame_s);
        if (!there) expected = copy_of(stepper->positions_mm());
        EXPECT_TRUE(std::ranges::equal(expected, stepper->positions_mm()));
        EXPECT_EQ(stepper->checkpoint().obstacles.has_value(), there);
    }
}

// A bar that runs through a tumour: nothing pushes it at rest, nor where it is pulled a little;
// with the tumour as a shell, what is outside of it is left out for good.
TEST(Obstacle, WhatOverlapsAtRestIsNotPushed) {
    for (const SurfaceKind kind : {SurfaceKind::solid, SurfaceKind::shell}) {
        BodyDescription body = test::bar();
        body.touchable = false;
        body.obstacles = one_obstacle(ball_surface(Vec3(30.3, 3.2, 3.1), 7.0), 0.2, kind);
        const auto stepper = make_cpu_stepper(body, {});
        for (int k = 0; k < 30; ++k) EXPECT_EQ(stepper->step(frame_s).obstacles.touch.contacts, 0);
        for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v)
            EXPECT_LT((stepper->positions_mm()[v] - body.mesh.vertices_mm[v]).norm(), 1e-9);
        ASSERT_TRUE(stepper->checkpoint().obstacles);
        EXPECT_FALSE(stepper->checkpoint().obstacles->touch.overlaps.buried.empty());
    }
}

// A short bar with one end in a tumour is pulled out of it, and then stays out.
TEST(Obstacle, WhatComesOutOfATumourStaysOut) {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(2, 2, 12), {1, 1, 6});
    for (Vec3& x : body.mesh.vertices_mm) x -= Vec3(1, 1, 0);
    body.tether_pa_per_mm2 = 1.0;
    body.obstacles = one_obstacle(ball_surface(Vec3(0.2, 0.1, -3.0), 6.0));
    ASSERT_GT(points_inside(surface_of_first(body), body.mesh.vertices_mm), 0);
    const auto stepper = make_cpu_stepper(body, {});
    const int top = nearest_vertex(body, Vec3(-1, -1, 12));
    const auto lead = [&](double up, int steps) {
        int touched = 0;
        for (int k = 0; k < steps; ++k) {
            const Vec3 to = body.mesh.vertices_mm[top] + Vec3(0, 0, up);
            stepper->set_grabs(std::vector{hand_at(top, to, 3e4)});
            touched += stepper->step(frame_s).obstacles.touch.contacts > 0 ? 1 : 0;
        }
        return touched;
    };
    lead(10.0, 120);
    EXPECT_EQ(points_inside(surface_of_first(body), stepper->positions_mm()), 0);
    EXPECT_EQ(crossings_with_obstacles(body, *stepper), 0);
    EXPECT_GT(lead(-8.0, 120), 10);
    EXPECT_EQ(points_inside(surface_of_first(body), stepper->positions_mm()), 0);
    EXPECT_EQ(crossings_with_obstacles(body, *stepper), 0);
}

// Pulled up against the tumour, along it, and let go.
void play_against(Stepper& stepper, const BodyDescription& body, int k) {
    const int held = nearest_vertex(body, Vec3(30, 3, 6));
    if (k < 60)
        stepper.set_grabs(std::vector{
            hand_at(held, body.mesh.vertices_mm[held] + Vec3(0.05, 0.02, 0.1) * (k + 1))});
    if (k == 60) stepper.set_grabs({});
}

TEST(Obstacle, TheSameCommandsGiveTheSameBitsForAnyNumberOfThreads) {
    const BodyDescription body = bar_below_a_ball();
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        const auto stepper = make_cpu_stepper(body, {});
        std::uint64_t all = 0;
        int touched = 0;
        for (int k = 0; k < 90; ++k) {
            play_against(*stepper, body, k);
            touched += stepper->step(frame_s).obstacles.touch.contacts;
            all = 31 * all + stepper->state_hash();
        }
        EXPECT_GT(touched, 30);
        hashes.push_back(all);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

class ObstacleCheckpointTest : public testing::TestWithParam<LinearSolverKind> {};

// In the middle of contact, through bytes.
TEST_P(ObstacleCheckpointTest, ARestoredStepperGoesOnToTheLastBit) {
    for (const bool region : {false, true}) {
        BodyDescription body = bar_below_a_ball();
        if (region) body.tether_pa_per_mm2 = 20.0;
        const auto make = [&]() -> std::unique_ptr<Stepper> {
            if (region) return make_live_stepper(body, {.solver = GetParam()});
            return make_cpu_stepper(body, {.solver = GetParam()});
        };
        const auto step = [&](Stepper& stepper, int k) {
            play_against(stepper, body, k);
            const StepReport report = stepper.step(frame_s);
            if (k == 50) {
                EXPECT_GT(report.obstacles.touch.contacts, 0);
            }
        };
        for (const int kept_at : {5, 50, 70})
            EXPECT_TRUE(test::expect_same_bits_from(kept_at, 90, make, step).obstacles) << region;
    }
}

INSTANTIATE_TEST_SUITE_P(Solvers, ObstacleCheckpointTest,
                         testing::Values(LinearSolverKind::automatic, LinearSolverKind::skeleton));

TEST(Obstacle, ACheckpointWithoutThemIsRefused) {
    BodyDescription body = bar_below_a_ball();
    const auto beside = make_cpu_stepper(body, {});
    body.obstacles.reset();
    const auto alone = make_cpu_stepper(body, {});
    EXPECT_THROW(beside->restore(alone->checkpoint()), InputError);
    EXPECT_THROW(alone->restore(beside->checkpoint()), InputError);
}

TEST(Obstacle, TheLedgerCloses) {
    const BodyDescription body = bar_below_a_ball();
    const auto stepper = make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-8}});
    double pressed = 0.0, rubbed = 0.0, stored = 0.0;
    for (int k = 0; k < 90; ++k) {
        play_against(*stepper, body, k);
        const EnergyLedger ledger = stepper->step(frame_s).energy;
        const double open = std::abs(stored_energy(ledger) - stored - explained_change(ledger)) /
                            (stored + energy_handled(ledger) + 1e-300);
        EXPECT_LT(open, 1e-9) << "step " << k;
        stored = stored_energy(ledger);
        pressed = std::max(pressed, ledger.contact);
        rubbed += ledger.friction_loss;
    }
    EXPECT_GT(pressed, 0.0);
    EXPECT_GT(rubbed, 0.0);
}

// Torn beside a tumour that it is pulled against, and that its other end lies in.
TEST(Obstacle, WhatTearsGoesOnToTouch) {
    BodyDescription body = bar_below_a_ball();
    TearLaw law;
    law.strength_pa = 4e3;
    law.fracture_energy_j_m2 = 0.5;
    body.tear = law;
    Obstacles both = *body.obstacles;
    both.all.push_back({ball_surface(Vec3(58, 3, 3), 6.0), SurfaceKind::solid});
    body.obstacles = std::make_shared<const Obstacles>(both);
    const int held = nearest_vertex(body, Vec3(30, 3, 6));
    const auto stepper = make_cpu_stepper(body, {});
    int split = 0, touched = 0;
    for (int k = 0; k < 90; ++k) {
        const Vec3 to = body.mesh.vertices_mm[held] + Vec3(0.02, 0.0, 0.3) * (k + 1);
        stepper->set_grabs(std::vector{hand_at(held, to, 1e6)});
        const StepReport report = stepper->step(frame_s);
        split = report.tear.vertices_split;
        touched += report.obstacles.touch.contacts > 0 ? 1 : 0;
        ASSERT_EQ(points_inside(surface_of_first(body), stepper->positions_mm()), 0) << k;
    }
    EXPECT_GT(split, 0);
    EXPECT_GT(touched, 10);
    EXPECT_FALSE(stepper->checkpoint().obstacles->touch.overlaps.buried.empty());
    const auto second = make_cpu_stepper(body, {});
    second->restore(checkpoint_from_bytes(to_bytes(stepper->checkpoint())));
    EXPECT_EQ(second->state_hash(), stepper->state_hash());
    for (int k = 0; k < 5; ++k) {
        stepper->step(frame_s);
        second->step(frame_s);
        EXPECT_EQ(second->state_hash(), stepper->state_hash());
    }
}

// Friction depends on all forces, so that the checkpoint of an older matrix holds its gravity.
TEST(Obstacle, AnOldMatrixWithFrictionIsMadeAgainWithItsGravity) {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(40, 4, 4), {12, 1, 1});
    body.tether_pa_per_mm2 = 0.05;
    body.obstacles = test::one_obstacle(
        test::box_surface(Vec3(-20, -20, -8.35), Vec3(100, 50, 8), {6, 4, 2}), 0.3);
    StepperOptions options;
    options.solver = LinearSolverKind::skeleton;
    options.linear.energy_tolerance = 0.2;
    const auto make = [&] { return make_cpu_stepper(body, options); };
    const auto step = [](Stepper& stepper, int k) {
        if (k == 0) stepper.set_gravity({4000.0, 1500.0, -9810.0});
        stepper.step(frame_s);
    };
    for (int kept_at = 0; kept_at < 20; ++kept_at)
        test::expect_same_bits_from(kept_at, kept_at + 2, make, step);
}

}  // namespace
}  // namespace hepatica
