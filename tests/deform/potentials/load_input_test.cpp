// SPDX-License-Identifier: GPL-3.0-or-later
// What acts on a body, its material and the options of a step are taken up to the limits that are
// written, and refused just beyond them.
#include "core/deform/potentials/load_input.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/base/error.h"
#include "core/deform/body/element_name.h"
#include "core/deform/body/material.h"
#include "core/deform/step/step_input.h"
#include "core/deform/step/step_report.h"
#include "core/deform/stepper/quality_dial.h"
#include "core/deform/stepper/stepper_input.h"

namespace hepatica {
namespace {

constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double infinite = std::numeric_limits<double>::infinity();

template <class Checked>
using Changes = std::vector<std::function<void(Checked&)>>;

template <class Checked, class Check>
void expect_limits(const Checked& good, const Changes<Checked>& taken,
                   const Changes<Checked>& refused, const Check& check) {
    EXPECT_NO_THROW(check(good));
    for (std::size_t k = 0; k < taken.size(); ++k) {
        Checked changed = good;
        taken[k](changed);
        EXPECT_NO_THROW(check(changed)) << "taken " << k;
    }
    for (std::size_t k = 0; k < refused.size(); ++k) {
        Checked changed = good;
        refused[k](changed);
        EXPECT_THROW(check(changed), InputError) << "refused " << k;
    }
}

TEST(LoadLimits, OfGrabs) {
    const Grab good{.vertices = {9, -1, 0, -1},
                    .weights = {0.7, 50.0, 0.3, 50.0},
                    .stiffness_un_per_mm = 1.0,
                    .force_limit_un = 1.0};
    expect_limits<Grab>(
        good,
        {[](Grab& g) { g.weights[0] += 0.9e-6; }, [](Grab& g) { g.weights[0] -= 0.9e-6; },
         [](Grab& g) { g.vertices[0] = 0; }, [](Grab& g) { g.stiffness_un_per_mm = least; },
         [](Grab& g) { g.force_limit_un = least; }},
        {[](Grab& g) { g.weights[0] += 1.1e-6; }, [](Grab& g) { g.weights[0] -= 1.1e-6; },
         [](Grab& g) { g.vertices[0] = -1; }, [](Grab& g) { g.vertices[0] = 10; },
         [](Grab& g) { g.vertices[2] = 10; }, [](Grab& g) { g.target_mm.y() = infinite; },
         [](Grab& g) { g.stiffness_un_per_mm = 0.0; },
         [](Grab& g) { g.stiffness_un_per_mm = infinite; }, [](Grab& g) { g.force_limit_un = 0.0; },
         [](Grab& g) { g.force_limit_un = infinite; }},
        [](const Grab& grab) { validate_grabs(std::span(&grab, 1), 10); });
}

TEST(LoadLimits, OfTools) {
    Tool good = single_tool({.centre_mm = Vec3(1, 2, 3), .radius_mm = 1.0});
    good.pad_mm = good.pressure_pa = 1.0;
    expect_limits<Tool>(
        good,
        {[](Tool& t) { t.parts[0].shape.radius_mm = least; }, [](Tool& t) { t.pad_mm = least; },
         [](Tool& t) { t.pressure_pa = least; }, [](Tool& t) { t.friction = 0.0; },
         [](Tool& t) { t.friction = 3.0; }, [](Tool& t) { t.force_limit_un = least; },
         [](Tool& t) { t.led_over_s = least; }, [](Tool& t) { t.opening_mm = 0.0; },
         [](Tool& t) { t.opening_target_mm = 5.0; }},
        {[](Tool& t) { t.parts.clear(); },
         [](Tool& t) { t.parts[0].shape.radius_mm = 0.0; },
         [](Tool& t) { t.parts[0].shape.radius_mm = infinite; },
         [](Tool& t) { t.parts[0].shape.centre_mm.x() = infinite; },
         [](Tool& t) { t.parts[0].shape.half_axis_mm.z() = infinite; },
         [](Tool& t) { t.parts[0].opens.y() = infinite; },
         [](Tool& t) { t.parts[0].led_by_mm.y() = infinite; },
         [](Tool& t) { t.parts[0].led_half_axis_mm.x() = infinite; },
         [](Tool& t) { t.target_mm.x() = infinite; },
         [](Tool& t) { t.turn_rad.x() = infinite; },
         [](Tool& t) { t.led_over_s = 0.0; },
         [](Tool& t) { t.led_over_s = infinite; },
         [](Tool& t) { t.opening_mm = -least; },
         [](Tool& t) { t.opening_mm = infinite; },
         [](Tool& t) { t.opening_target_mm = -least; },
         [](Tool& t) { t.opening_target_mm = infinite; },
         [](Tool& t) { t.pad_mm = 0.0; },
         [](Tool& t) { t.pad_mm = infinite; },
         [](Tool& t) { t.pressure_pa = 0.0; },
         [](Tool& t) { t.pressure_pa = infinite; },
         [](Tool& t) { t.friction = -least; },
         [](Tool& t) { t.friction = infinite; },
         [](Tool& t) { t.force_limit_un = 0.0; },
         [](Tool& t) { t.force_limit_un = infinite; }},
        [](const Tool& tool) { validate_tool(tool, true); });
    EXPECT_THROW(validate_tool(good, false), InputError);
}

TEST(LoadLimits, OfMaterials) {
    const auto check = [](const Material& material) { validate(material); };
    expect_limits<Material>(
        {},
        {[](Material& m) { m.young_modulus_pa = least; },
         [](Material& m) { m.poisson_ratio = 0.0; }, [](Material& m) { m.poisson_ratio = 0.49999; },
         [](Material& m) { m.density_g_mm3 = least; }, [](Material& m) { m.damping_ratio = 0.0; },
         [](Material& m) { m.damping_low_hz = least; },
         [](Material& m) { m.damping_high_hz = m.damping_low_hz; }},
        {[](Material& m) { m.young_modulus_pa = 0.0; },
         [](Material& m) { m.young_modulus_pa = infinite; },
         [](Material& m) { m.poisson_ratio = -least; },
         [](Material& m) { m.poisson_ratio = 0.499991; },
         [](Material& m) { m.density_g_mm3 = 0.0; },
         [](Material& m) { m.density_g_mm3 = infinite; },
         [](Material& m) { m.damping_ratio = -least; },
         [](Material& m) { m.damping_ratio = infinite; },
         [](Material& m) { m.damping_low_hz = 0.0; },
         [](Material& m) { m.damping_high_hz = 0.99 * m.damping_low_hz; },
         [](Material& m) { m.damping_high_hz = infinite; }},
        check);
}

TEST(LoadLimits, OfOptions) {
    using Options = StepperOptions;
    expect_limits<Options>(
        {},
        {[](Options& o) { o.newton_tolerance = least; },
         [](Options& o) { o.linear.max_iterations = 1; },
         [](Options& o) { o.linear.energy_tolerance = 0.0; },
         [](Options& o) { o.linear.residual_tolerance = 1.0; },
         [](Options& o) { o.velocity_error.alpha_per_s = -3.0; }},
        {[](Options& o) { o.newton_iterations = 0; }, [](Options& o) { o.newton_tolerance = 0.0; },
         [](Options& o) { o.newton_tolerance = infinite; }, [](Options& o) { o.substeps = 0; },
         [](Options& o) { o.linear.max_iterations = 0; },
         [](Options& o) { o.linear.energy_tolerance = -least; },
         [](Options& o) { o.linear.energy_tolerance = infinite; },
         [](Options& o) { o.linear.residual_tolerance = -least; },
         [](Options& o) { o.linear.residual_tolerance = infinite; },
         [](Options& o) { o.velocity_error.alpha_per_s = infinite; },
         [](Options& o) { o.velocity_error.beta_s = infinite; }},
        [](const Options& options) { validate(options); });
}

TEST(LoadLimits, OfTimeStepsAndStates) {
    EXPECT_NO_THROW(validate_time_step(least));
    for (const double wrong : {0.0, -1.0, infinite})
        EXPECT_THROW(validate_time_step(wrong), InputError);
    const std::vector<Vec3> two(2, Vec3::Ones()), three(3, Vec3::Ones());
    std::vector<Vec3> broken = two;
    broken[1].z() = infinite;
    EXPECT_NO_THROW(validate_state(two, two, 2));
    EXPECT_THROW(validate_state(three, two, 2), InputError);
    EXPECT_THROW(validate_state(two, three, 2), InputError);
    EXPECT_THROW(validate_state(broken, two, 2), InputError);
    EXPECT_THROW(validate_state(two, broken, 2), InputError);
    EXPECT_THROW(validate_gravity(Vec3(0, infinite, 0)), InputError);
    EXPECT_NO_THROW(validate_gravity(Vec3(0, -1e9, 0)));
}

TEST(LoadLimits, DefaultsAreThoseThatAreDocumented) {
    const StepperOptions options;
    EXPECT_EQ(options.model, ElementModel::corotated);
    EXPECT_EQ(options.solver, LinearSolverKind::automatic);
    EXPECT_EQ(options.newton_iterations, 1);
    EXPECT_EQ(options.newton_tolerance, 1e-6);
    EXPECT_EQ(options.substeps, 1);
    EXPECT_FALSE(options.published);
    EXPECT_TRUE(options.sleeping);
    EXPECT_FALSE(options.audit);
    EXPECT_EQ(options.linear.energy_tolerance, 1e-2);
    EXPECT_EQ(options.linear.residual_tolerance, 0.0);
    EXPECT_EQ(options.linear.max_iterations, 10000);
    EXPECT_EQ(energy_handled({}), 0.0);
    EXPECT_EQ(explained_change({}), 0.0);
    EXPECT_EQ(EnergyLedger{}.imbalance, 0.0);
}

TEST(LoadLimits, ElementsHaveTheNamesThatFilesUse) {
    for (const std::string name :
         {"spring", "corotated", "neohookean", "corotated-10", "neohookean-10"}) {
        const auto [model, order] = element_of(name);
        EXPECT_EQ(element_name(model, order), name);
        EXPECT_EQ(order == ElementOrder::quadratic, name.ends_with("-10"));
    }
    EXPECT_EQ(element_name(ElementModel::spring, ElementOrder::quadratic), "unknown");
    EXPECT_THROW(element_of("spring-10"), UsageError);
}

// Efforts are summed, errors are the larger, energies those of the end.
TEST(LoadLimits, TwoReportsInSequence) {
    StepReport a, b;
    a.dt_s = 0.25, b.dt_s = 0.5;
    a.newton_iterations = 2, b.newton_iterations = 5;
    a.linear_solves = 3, b.linear_solves = 6;
    a.linear_iterations = 4, b.linear_iterations = 8;
    a.linear_residual = 0.5, b.linear_residual = 0.25;
    a.linear_energy_error = 0.125, b.linear_energy_error = 0.75;
    a.dropped_pivots = 7, b.dropped_pivots = 2;
    a.degraded = true, b.shortened = true;
    a.message = "first";
    a.tool.impulse_un_s = Vec3(1, 2, 3), b.tool.impulse_un_s = Vec3(10, 20, 30);
    a.self = {.contacts = 4, .least_gap_mm = 0.5};
    b.self = {.contacts = 3, .least_gap_mm = 0.25};
    a.self_cost.step_ms = 1.0, b.self_cost.step_ms = 2.0;
    a.momentum_error_g_mm_per_s = 1.0, b.momentum_error_g_mm_per_s = 4.0;
    a.momentum_exchanged_g_mm_per_s = 2.0, b.momentum_exchanged_g_mm_per_s = 8.0;
    a.audit_gap_nj = 3.0, b.audit_gap_nj = 16.0;
    a.audit_error_nj = 5.0, b.audit_error_nj = 32.0;
    const StepReport both = in_sequence(a, b);
    EXPECT_EQ(both.dt_s, 0.75);
    EXPECT_EQ(both.newton_iterations, 7);
    EXPECT_EQ(both.linear_solves, 9);
    EXPECT_EQ(both.linear_iterations, 12);
    EXPECT_EQ(both.linear_residual, 0.5);
    EXPECT_EQ(both.linear_energy_error, 0.75);
    EXPECT_EQ(both.dropped_pivots, 7);
    EXPECT_TRUE(both.degraded && both.shortened);
    EXPECT_EQ(both.message, "first");
    EXPECT_EQ(both.tool.impulse_un_s, Vec3(11, 22, 33));
    EXPECT_EQ(both.self.contacts, 4);
    EXPECT_EQ(both.self.least_gap_mm, 0.25);
    EXPECT_EQ(both.self_cost.step_ms, 3.0);
    EXPECT_EQ(both.momentum_error_g_mm_per_s, 5.0);
    EXPECT_EQ(both.momentum_exchanged_g_mm_per_s, 10.0);
    EXPECT_EQ(both.audit_gap_nj, 19.0);
    EXPECT_EQ(both.audit_error_nj, 37.0);
    b.message = "second";
    EXPECT_EQ(in_sequence(a, b).message, "second");
    const StepReport none = in_sequence(StepReport{}, StepReport{});
    EXPECT_FALSE(none.degraded || none.shortened || none.predicted || none.asleep);
}

}  // namespace
}  // namespace hepatica
