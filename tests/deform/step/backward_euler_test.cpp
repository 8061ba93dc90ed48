// SPDX-License-Identifier: GPL-3.0-or-later
// The budget of a step: counted in linear solves, small, and kept whatever the body does.
#include "core/deform/step/backward_euler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "core/base/frame_time.h"
#include "core/base/units.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/odd_solver.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

constexpr int extra_solves = NewtonSettings{}.extra_solves;

Body clamped_bar() {
    BodyDescription d;
    d.mesh = kuhn_brick(Vec3(100, 20, 20), {10, 2, 2});
    for (const Vec3& x : d.mesh.vertices_mm) d.fixed.push_back(x[0] == 0.0);
    return build_body(d, ElementModel::corotated, ElementOrder::linear);
}

// A bar that a thousandfold gravity throws through its own clamp in steps of a second: most have to
// be shortened, some cut, until the budget is used up.
TEST(BackwardEuler, ANastyStepKeepsItsBudgetOfSolvesMakesNoEnergyAndStaysFinite) {
    const Body body = clamped_bar();
    for (const int iterations : {1, 6}) {
        int solves = 0;
        BackwardEuler integrator(body,
                                 {.iterations = iterations, .linear = {.energy_tolerance = 1e-6}},
                                 std::make_unique<test::OddSolver>(solves));
        PotentialList weight(body);
        weight.set_gravity(-1000.0 * units::standard_gravity * Vec3(1, 0, 1));
        BodyState state{body.rest_positions_mm,
                        std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
        double before = 0.0;
        for (int i = 0; i < 40; ++i) {
            solves = 0;
            const StepReport report = integrator.advance(state, 1.0, weight);
            EXPECT_EQ(report.linear_solves, solves) << "step " << i;
            EXPECT_LE(solves, iterations + extra_solves) << "step " << i;
            EXPECT_EQ(report.dt_s, 1.0);
            const double made = stored_energy(report.energy) - before - report.energy.gravity_work;
            EXPECT_LT(made, 1e-9 * energy_handled(report.energy)) << report.message;
            before = stored_energy(report.energy);
            for (const Vec3& x : state.positions_mm) ASSERT_TRUE(x.allFinite());
        }
    }
}

// Where every direction points uphill the step is cut in halves until its solves are used up, and
// the body stays where it is.
TEST(BackwardEuler, AStepThatOnlyFindsWaysUphillUsesUpItsBudgetAndStops) {
    const Body body = clamped_bar();
    int solves = 0;
    BackwardEuler integrator(body, {}, std::make_unique<test::OddSolver>(solves, 1000));
    PotentialList weight(body);
    weight.set_gravity(Vec3(0, 0, -units::standard_gravity));
    BodyState state{body.rest_positions_mm, std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
    const StepReport report = integrator.advance(state, 0.01, weight);
    EXPECT_EQ(report.linear_solves, solves);
    EXPECT_LE(solves, 1 + extra_solves);
    EXPECT_GT(solves, 1 + extra_solves / 2);
    EXPECT_TRUE(report.degraded);
    EXPECT_LT(relative_imbalance(report.energy), 1e-10);
    EXPECT_EQ(stored_energy(report.energy), 0.0);
    for (std::size_t i = 0; i < state.positions_mm.size(); ++i)
        EXPECT_EQ(state.positions_mm[i], body.rest_positions_mm[i]);
}

// The report of a step that was cut in halves: by a first try that found no way, whose solve
// dropped pivots, or with a half that says so itself.
TEST(BackwardEuler, AStepInHalvesReportsThePivotsOfEverySolve) {
    const Body body = clamped_bar();
    PotentialList weight(body);
    weight.set_gravity(Vec3(0, 0, -units::standard_gravity));
    for (const int dropping : {1, 2}) {
        int solves = 0;
        test::OddSolver* odd = nullptr;
        auto made = std::make_unique<test::OddSolver>(solves, 1, [&] {
            if (solves + 1 == dropping) odd->drops = 3;
        });
        odd = made.get();
        odd->drops = dropping == 1 ? 3 : 0;
        BackwardEuler integrator(body, {}, std::move(made));
        BodyState state{body.rest_positions_mm,
                        std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
        const StepReport report = integrator.advance(state, 0.01, weight);
        ASSERT_GE(report.linear_solves, 3) << "the step was not cut";
        EXPECT_EQ(report.dropped_pivots, 3) << dropping;
        EXPECT_TRUE(report.degraded);
        EXPECT_NE(report.message.find(dropping == 1 ? "cut in halves" : "positive definite"),
                  std::string::npos)
            << report.message;
    }
}

// One iterate suffices in free flight without damping, and began from the present velocity as well.
TEST(BackwardEuler, SaysThatAStepInFreeFlightWasPredicted) {
    BodyDescription description;
    description.mesh = kuhn_brick(Vec3(40, 8, 8), {10, 2, 2});
    for (const double damping_ratio : {0.0, Material{}.damping_ratio}) {
        description.material.damping_ratio = damping_ratio;
        const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
        BackwardEuler integrator(body, {}, make_block_jacobi_solver());
        const PotentialList none(body);
        BodyState state{body.rest_positions_mm,
                        std::vector<Vec3>(body.mass_g.size(), Vec3(100, 0, 0))};
        EXPECT_TRUE(integrator.advance(state, 1.0 / 60.0, none).predicted) << damping_ratio;
    }
}

// Numbers so large that forces overflow: no direction is one, and the step says so.
TEST(BackwardEuler, AStepWithoutAFiniteDirectionStopsTheBodyAndSaysSo) {
    const Body body = clamped_bar();
    int solves = 0;
    BackwardEuler integrator(body, {}, std::make_unique<test::OddSolver>(solves));
    const PotentialList none(body);
    BodyState state{body.rest_positions_mm, std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
    for (std::size_t i = 0; i < state.positions_mm.size(); ++i)
        if (!body.fixed[i]) state.positions_mm[i] *= 1e200;
    const std::vector<Vec3> start = state.positions_mm;
    const StepReport report = integrator.advance(state, 1.0 / 60.0, none);
    EXPECT_TRUE(report.degraded);
    EXPECT_LE(solves, 1 + extra_solves);
    for (const Vec3& x : state.positions_mm) EXPECT_TRUE(x.allFinite());
    for (const Vec3& v : state.velocities_mm_per_s) EXPECT_TRUE(v.allFinite());
}

// A bar led at a steady speed: begun where the body would be without a change of velocity, one
// iterate leaves a small share of the residual that the published step, begun at rest, leaves.
TEST(BackwardEuler, ASteadyMotionIsPredicted) {
    const Body body = clamped_bar();
    const auto missed = [&](bool published) {
        BackwardEuler integrator(body,
                                 {.line_search = !published, .linear = {.energy_tolerance = 1e-10}},
                                 make_block_jacobi_solver());
        BackwardEuler exact(
            body, {.iterations = 40, .tolerance = 1e-12, .linear = {.energy_tolerance = 1e-10}},
            make_block_jacobi_solver());
        PotentialList hand(body);
        int tip = 0;
        for (int i = 0; i < body.node_count(); ++i)
            if (body.rest_positions_mm[i].sum() > body.rest_positions_mm[tip].sum()) tip = i;
        Grab grab{.vertices = {tip, -1, -1, -1}};
        grab.stiffness_un_per_mm = 1e6;
        grab.force_limit_un = 1e9;
        BodyState state{body.rest_positions_mm,
                        std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
        double sum = 0.0;
        for (int k = 0; k < 30; ++k) {
            grab.target_mm = body.rest_positions_mm[tip] + Vec3(0, 0, 1.0 * (k + 1));
            hand.set_grabs(std::span(&grab, 1));
            BodyState truth = state;
            exact.forget();
            exact.advance(truth, 1.0 / 60.0, hand);
            integrator.advance(state, 1.0 / 60.0, hand);
            if (k < 10) continue;  // until it has the hand's speed
            for (std::size_t i = 0; i < truth.positions_mm.size(); ++i)
                sum += (truth.positions_mm[i] - state.positions_mm[i]).squaredNorm();
        }
        return std::sqrt(sum);
    };
    EXPECT_LT(missed(false), 0.3 * missed(true));
}

// A cube that falls onto a slab with a corner first: the one coupling is left to iterations around
// the solver, which has to learn what they cost.
TEST(BackwardEuler, TellsTheSolverOfSolvesThatItOnlyPreconditions) {
    BodyDescription two;
    test::add_mesh(test::bar_at(Vec3(8, 8, 4), {2, 2, 1}, Mat3::Identity(), Vec3::Zero()),
                   two.mesh);
    const std::size_t slab = two.mesh.vertices_mm.size();
    const Mat3 corner_down =
        Eigen::Quaterniond::FromTwoVectors(Vec3(1, 1, 1), Vec3(0, 0, -1)).toRotationMatrix();
    test::add_mesh(test::bar_at(Vec3(4, 4, 4), {1, 1, 1}, corner_down,
                                Vec3(1.1, 0.7, 2.3 + 2.0 * std::sqrt(3.0))),
                   two.mesh);
    two.self.emplace();
    const Body body = build_body(two, ElementModel::corotated, ElementOrder::linear);
    int solves = 0;
    auto made = std::make_unique<test::OddSolver>(solves);
    const test::OddSolver& solver = *made;
    BackwardEuler integrator(body, {}, std::move(made));
    PotentialList potentials(body);
    BodyState state{body.rest_positions_mm, std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
    for (std::size_t i = slab; i < state.velocities_mm_per_s.size(); ++i)
        state.velocities_mm_per_s[i].z() = -20.0;
    int linear_solves = 0;
    for (int k = 0; k < 10; ++k)
        linear_solves += integrator.advance(state, frame_s, potentials).linear_solves;
    ASSERT_LT(solves, linear_solves) << "nothing touched";
    EXPECT_EQ(std::ssize(solver.worn), linear_solves - solves);
    for (const int iterations : solver.worn) EXPECT_GT(iterations, 0);
}

}  // namespace
}  // namespace hepatica
