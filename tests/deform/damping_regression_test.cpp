// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/damping_regression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/deform/cpu_stepper.h"
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
    const RayleighDamping sum = combined(body.damping, fit);
    EXPECT_GE(sum.alpha_per_s, 0.0);
    EXPECT_GE(sum.beta_s, 0.0);
    if (!fit.used) {
        EXPECT_EQ(sum.beta_s, body.damping.beta_s);
    }
}

}  // namespace
}  // namespace hepatica
