// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger of energy from step to step, and the step that may make none.
#include "core/deform/body/energy_ledger.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/units.h"
#include "core/deform/step/backward_euler.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/odd_solver.h"

namespace hepatica {
namespace {

// A beam along x, clamped at x = 0.
BodyDescription beam(const Vec3& size_mm, const Index3& cells) {
    BodyDescription body;
    body.mesh = kuhn_brick(size_mm, cells);
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x[0] == 0.0);
    return body;
}

// What the ledger leaves open between the energies before and after, relative to what is handled.
double left_open(double stored_before, const EnergyLedger& ledger) {
    return std::abs(stored_energy(ledger) - stored_before - explained_change(ledger)) /
           (stored_before + energy_handled(ledger));
}

// Where no share of the first direction lowers the potential the step is cut in halves: two steps
// of half the time with half of the solves that it had left, and what it does is what they do.
TEST(EnergyLedger, AStepCutInHalvesIsTwoStepsOfHalfTheTime) {
    const Body body = build_body(beam(Vec3(100, 20, 20), {10, 2, 2}), ElementModel::corotated,
                                 ElementOrder::linear);
    PotentialList weight(body);
    weight.set_gravity(-units::standard_gravity * Vec3(1, 0, 1));
    NewtonSettings settings{.linear = {.energy_tolerance = 1e-12}};
    int solves = 0;
    BackwardEuler whole_steps(body, settings, std::make_unique<test::OddSolver>(solves, 1));
    BackwardEuler half_steps(body, settings, make_block_jacobi_solver());
    BodyState state{body.rest_positions_mm, std::vector<Vec3>(body.mass_g.size(), Vec3::Zero())};
    BodyState halves = state;
    const StepReport whole = whole_steps.advance(state, 0.1, weight);
    EXPECT_NE(whole.message.find("halves"), std::string::npos);
    EXPECT_EQ(whole.dt_s, 0.1);
    EXPECT_LT(relative_imbalance(whole.energy), 1e-10);
    const StepReport first = half_steps.advance(halves, 0.05, weight);
    const StepReport both = in_sequence(first, half_steps.advance(halves, 0.05, weight));
    EXPECT_EQ(whole.linear_solves, 1 + both.linear_solves);
    EXPECT_EQ(whole.linear_solves, solves);
    const double size = energy_handled(both.energy);
    EXPECT_NEAR(whole.energy.gravity_work, both.energy.gravity_work, 1e-6 * size);
    EXPECT_NEAR(whole.energy.integrator_loss, both.energy.integrator_loss, 1e-6 * size);
    for (std::size_t v = 0; v < halves.positions_mm.size(); ++v)
        EXPECT_LT((state.positions_mm[v] - halves.positions_mm[v]).norm(), 1e-6);
}

// Without the check of the energy in the step's velocities, one of these steps makes 2 %.
TEST(EnergyLedger, NoStepOfAWhippingBeamMakesEnergy) {
    BodyDescription body = beam(Vec3(60, 8, 8), {12, 2, 2});
    body.material.damping_ratio = 0.0;
    const auto stepper = make_cpu_stepper(body, {});
    stepper->set_gravity(Vec3(0, 0, -10.0 * units::standard_gravity));
    double before = 0.0, handled = 0.0;
    for (int i = 0; i < 240; ++i) {
        const EnergyLedger ledger = stepper->step(1.0 / 240.0).energy;
        handled = std::max(handled, energy_handled(ledger));
        EXPECT_LT(stored_energy(ledger) - before - work_put_in(ledger), 1e-8 * handled)
            << "step " << i;
        before = stored_energy(ledger);
    }
    EXPECT_GT(before, 0.0);
}

TEST(EnergyLedger, AddsUpOverGrabsThatMoveAndSubsteps) {
    for (const int substeps : {1, 3}) {
        const BodyDescription body = beam(Vec3(60, 8, 8), {12, 2, 2});
        const auto stepper = make_cpu_stepper(body, {.substeps = substeps});
        stepper->set_gravity(Vec3(0, 0, -units::standard_gravity));
        const int tip = static_cast<int>(body.mesh.vertices_mm.size()) - 1;
        double before = 0.0, tools = 0.0, damped = 0.0;
        for (int i = 0; i < 90; ++i) {
            Grab grab{.vertices = {tip, -1, -1, -1}};
            grab.target_mm = body.mesh.vertices_mm[tip] + Vec3(0, 20 * std::sin(0.1 * i), 0.2 * i);
            grab.stiffness_un_per_mm = 1e4;
            grab.force_limit_un = 5e4;
            if (i < 60)
                stepper->set_grabs(std::span(&grab, 1));
            else
                stepper->set_grabs({});
            const EnergyLedger ledger = stepper->step(1.0 / 60.0).energy;
            EXPECT_LT(left_open(before, ledger), 1e-10) << substeps << " substeps, step " << i;
            before = stored_energy(ledger);
            tools = std::max(tools, ledger.tool_work / energy_handled(ledger));
            damped = std::max(damped, ledger.damping_loss / energy_handled(ledger));
        }
        EXPECT_GT(tools, 1e-3);
        EXPECT_GT(damped, 1e-3);
    }
}

TEST(EnergyLedger, TwoStepsHaveTheEnergiesOfTheSecondAndTheWorksOfBoth) {
    const EnergyLedger first{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17};
    const EnergyLedger second{100,  200,  300,  400,  500,  600,  700,  800, 900,
                              1000, 1100, 1200, 1300, 1400, 1500, 1600, 1700};
    const EnergyLedger both = in_sequence(first, second);
    EXPECT_EQ(both.kinetic, 100);
    EXPECT_EQ(both.elastic, 200);
    EXPECT_EQ(both.grab, 300);
    EXPECT_EQ(both.tether, 400);
    EXPECT_EQ(both.contact, 500);
    EXPECT_EQ(both.cohesion, 600);
    EXPECT_EQ(both.gravity_work, 707);
    EXPECT_EQ(both.tool_work, 808);
    EXPECT_EQ(both.damping_loss, 909);
    EXPECT_EQ(both.friction_loss, 1010);
    EXPECT_EQ(both.integrator_loss, 1111);
    EXPECT_EQ(both.nonlinear_loss, 1212);
    EXPECT_EQ(both.limiter_loss, 1313);
    EXPECT_EQ(both.tear_loss, 1414);
    EXPECT_EQ(both.inversion_recovery_loss, 1515);
    EXPECT_EQ(both.solver_work, 1616);
    EXPECT_EQ(both.imbalance, 1717);
    EXPECT_EQ(stored_energy(both), 2100);
    EXPECT_EQ(work_put_in(both), 707 + 808);
    EXPECT_EQ(explained_change(both),
              707 + 808 - 909 - 1010 - 1111 - 1212 - 1313 - 1414 - 1515 + 1616);
}

}  // namespace
}  // namespace hepatica
