// SPDX-License-Identifier: GPL-3.0-or-later
// The budget of a step: counted in linear solves, small, and kept whatever the body does.
#include "core/deform/step/backward_euler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/units.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

constexpr int extra_solves = NewtonSettings{}.extra_solves;

// Counts what it is asked for.
class CountingSolver final : public LinearSolver {
  public:
    explicit CountingSolver(int& count) : count_(count), solver_(make_block_jacobi_solver()) {}
    void prepare(const BlockMatrix& matrix, std::span<const Vec3> positions_mm) override {
        solver_->prepare(matrix, positions_mm);
    }
    SolveReport solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                      const SolveLimits& limits) override {
        ++count_;
        return solver_->solve(rhs, x, limits);
    }
    std::string_view name() const override { return "counting"; }
    bool made_from_latest() const override { return false; }
    std::vector<double> memory() const override { return {}; }
    void restore(const BlockMatrix*, std::span<const Vec3>, std::span<const double>) override {}

  private:
    int& count_;
    std::unique_ptr<LinearSolver> solver_;
};

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
        int solves = 0, most = 0;
        BackwardEuler integrator(body,
                                 {.iterations = iterations, .linear = {.energy_tolerance = 1e-6}},
                                 std::make_unique<CountingSolver>(solves));
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
            most = std::max(most, solves);
            for (const Vec3& x : state.positions_mm) ASSERT_TRUE(x.allFinite());
        }
        EXPECT_GT(most, iterations + extra_solves / 2);  // the budget was needed
    }
}

// Numbers so large that forces overflow: no direction is one, and the step says so.
TEST(BackwardEuler, AStepWithoutAFiniteDirectionStopsTheBodyAndSaysSo) {
    const Body body = clamped_bar();
    int solves = 0;
    BackwardEuler integrator(body, {}, std::make_unique<CountingSolver>(solves));
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

}  // namespace
}  // namespace hepatica
