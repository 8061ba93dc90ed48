// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/damping_regression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/deform/step/assembly.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

std::vector<Vec3> random_field(std::mt19937_64& random, int size) {
    std::vector<Vec3> field(size);
    for (Vec3& x : field)
        for (int i = 0; i < 3; ++i) x[i] = static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0;
    return field;
}

TEST(DampingRegression, FindsCoefficientsThatAreThere) {
    std::mt19937_64 random(1);
    DampingRegression regression;
    for (int step = 0; step < 10; ++step) {
        const auto m_dv = random_field(random, 50), k_dv = random_field(random, 50);
        std::vector<Vec3> residual(50);
        for (int i = 0; i < 50; ++i) residual[i] = -(3.0 * m_dv[i] + 0.02 * k_dv[i]);
        regression.add(residual, m_dv, k_dv);
    }
    const DampingFit fit = regression.fit();
    EXPECT_TRUE(fit.used);
    EXPECT_EQ(fit.steps, 10);
    EXPECT_NEAR(fit.r_squared, 1.0, 1e-12);
    EXPECT_NEAR(fit.error.alpha_per_s, 3.0, 1e-10);
    EXPECT_NEAR(fit.error.beta_s, 0.02, 1e-10);
}

TEST(DampingRegression, IsZeroAndSaysSoWhereNothingIsExplained) {
    std::mt19937_64 random(2);
    DampingRegression regression;
    for (int step = 0; step < 10; ++step)
        regression.add(random_field(random, 50), random_field(random, 50),
                       random_field(random, 50));
    const DampingFit fit = regression.fit();
    EXPECT_FALSE(fit.used);
    EXPECT_LT(fit.r_squared, 0.05);
    EXPECT_EQ(fit.error.alpha_per_s, 0.0);
    EXPECT_EQ(fit.error.beta_s, 0.0);
    EXPECT_FALSE(DampingRegression{}.fit().used);
}

// Small motion is linear: the expansion misses nothing worth a fit. The residual of large motion is
// larger by orders.
TEST(DampingRegression, RunsOverRecordedSteps) {
    BodyDescription description;
    description.mesh = kuhn_brick(Vec3(60, 10, 10), {12, 2, 2});
    for (const Vec3& x : description.mesh.vertices_mm) description.fixed.push_back(x[0] == 0.0);
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    const auto stepper = make_cpu_stepper(description, {.linear = {.energy_tolerance = 1e-8}});
    stepper->set_gravity(Vec3(0, 0, -9810));
    std::vector<BodyState> recorded;
    for (int i = 0; i < 30; ++i) {
        stepper->step(1.0 / 60.0);
        recorded.push_back(
            {{stepper->positions_mm().begin(), stepper->positions_mm().end()},
             {stepper->velocities_mm_per_s().begin(), stepper->velocities_mm_per_s().end()}});
    }
    const DampingFit fit = fit_damping(body, recorded);
    EXPECT_EQ(fit.steps, 29);
    EXPECT_GE(fit.r_squared, 0.0);
    EXPECT_LE(fit.r_squared, 1.0);
}

// How far a step misses the nonlinear equations of backward Euler, M dv = dt f(x', v'), squared and
// summed over the nodes that may move.
double missed_momentum(const Body& body, const BodyState& before, const BodyState& after,
                       double dt_s, const Vec3& gravity) {
    Assembly assembly(body);
    assembly.evaluate(after.positions_mm);
    std::vector<Vec3> force(body.mass_g.size()), damped(body.mass_g.size());
    assembly.gather_forces(force);
    BlockMatrix stiffness;
    assembly.gather_stiffness(body.damping.beta_s, stiffness);
    multiply(stiffness, after.velocities_mm_per_s, damped);
    double sum = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
        if (body.fixed[i]) continue;
        const double mass = body.mass_g[i];
        const Vec3& v = after.velocities_mm_per_s[i];
        const Vec3 f = force[i] + mass * gravity - damped[i] - body.damping.alpha_per_s * mass * v;
        sum += (mass * (v - before.velocities_mm_per_s[i]) - dt_s * f).squaredNorm();
    }
    return sum;
}

struct Swing {
    BodyDescription description;
    Body body;
    StepperOptions options{.linear = {.energy_tolerance = 1e-10}, .published = true};
    std::vector<BodyState> recorded;
    double dt_s = 1.0 / 60.0;
    Vec3 gravity = Vec3(0, 0, -9810);
};

// A soft bar clamped at one end that falls from the horizontal: it turns far and fast.
Swing falling_bar() {
    Swing swing;
    swing.description.mesh = kuhn_brick(Vec3(120, 10, 10), {24, 2, 2});
    swing.description.material.young_modulus_pa = 2e4;
    for (const Vec3& x : swing.description.mesh.vertices_mm)
        swing.description.fixed.push_back(x[0] == 0.0);
    swing.body = build_body(swing.description, ElementModel::corotated, ElementOrder::linear);
    const auto stepper = make_cpu_stepper(swing.description, swing.options);
    stepper->set_gravity(swing.gravity);
    for (int i = 0; i < 60; ++i) {
        swing.recorded.push_back(stepper->state());
        stepper->step(swing.dt_s);
    }
    return swing;
}

// What a step misses when it is made again from every recorded state, with E.
double missed_with(const Swing& swing, const RayleighDamping& error) {
    StepperOptions options = swing.options;
    options.velocity_error = error;
    const auto stepper = make_cpu_stepper(swing.description, options);
    stepper->set_gravity(swing.gravity);
    double missed = 0.0;
    for (const BodyState& state : swing.recorded) {
        stepper->set_state(state.positions_mm, state.velocities_mm_per_s);
        stepper->step(swing.dt_s);
        missed += missed_momentum(swing.body, state, stepper->state(), swing.dt_s, swing.gravity);
    }
    return missed;
}

// R2 is the share of the expansion's residual that E explains; made anew with E, the same steps
// miss the nonlinear equations by less. Half of E does better than all of it: with E in the matrix
// the change of velocity, which E multiplies, grows.
TEST(DampingRegression, LowersWhatTheLinearisedStepMisses) {
    const Swing swing = falling_bar();
    const DampingFit fit = fit_damping(swing.body, swing.recorded);
    ASSERT_TRUE(fit.used);
    EXPECT_GT(fit.r_squared, 0.9);
    const double without = missed_with(swing, {});
    EXPECT_LT(missed_with(swing, fit.error), 0.8 * without);
    EXPECT_LT(missed_with(swing, {0.5 * fit.error.alpha_per_s, 0.5 * fit.error.beta_s}),
              0.2 * without);
}

// E is part of the first iterate's matrix only: it neither damps nor moves what Newton's method
// converges to, and the ledger still closes.
TEST(DampingRegression, AnErrorChangesNoConvergedStepAndMakesNoEnergy) {
    const Swing swing = falling_bar();
    StepperOptions options;
    options.linear.energy_tolerance = 1e-10;
    options.newton_iterations = 50;
    options.newton_tolerance = 1e-10;
    const auto plain = make_cpu_stepper(swing.description, options);
    options.velocity_error = {10.0, -0.004};
    const auto with = make_cpu_stepper(swing.description, options);
    options.newton_iterations = 1;
    const auto linearised = make_cpu_stepper(swing.description, options);
    for (const auto& stepper : {plain.get(), with.get(), linearised.get()})
        stepper->set_gravity(swing.gravity);
    for (int i = 0; i < 20; ++i) {
        plain->step(swing.dt_s);
        with->step(swing.dt_s);
        const EnergyLedger energy = linearised->step(swing.dt_s).energy;
        EXPECT_LT(std::abs(energy.imbalance),
                  1e-10 * (energy.kinetic + energy.elastic + std::abs(energy.gravity_work)));
    }
    for (std::size_t v = 0; v < plain->positions_mm().size(); ++v)
        EXPECT_LT((plain->positions_mm()[v] - with->positions_mm()[v]).norm(), 1e-5);
    options.velocity_error.beta_s = std::nan("");
    EXPECT_THROW(make_cpu_stepper(swing.description, options), InputError);
}

}  // namespace
}  // namespace hepatica
