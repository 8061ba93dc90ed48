// SPDX-License-Identifier: GPL-3.0-or-later
// Both back ends refuse the same input, and are afterwards as they were before.
#include "core/deform/stepper/stepper_input.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

const double nan = std::nan("");

BodyDescription bar_body() {
    return test::description_of(test::make_bar(24.0, 6.0, 8, 2));
}

using Make = std::unique_ptr<Stepper> (*)(const BodyDescription&, const StepperOptions&);

class StepperInput : public testing::TestWithParam<Make> {
  protected:
    std::unique_ptr<Stepper> make(const StepperOptions& options = {}) const {
        return GetParam()(bar_body(), options);
    }
    // Without forces for a second: what can rest, rests.
    std::unique_ptr<Stepper> asleep() const {
        auto stepper = make();
        for (int k = 0; k < 60; ++k) stepper->step(frame_s);
        EXPECT_TRUE(stepper->step(frame_s).asleep);
        return stepper;
    }
};

Grab some_grab() {
    Grab grab;
    grab.vertices[0] = 3;
    grab.target_mm = Vec3(1, 2, 3);
    grab.stiffness_un_per_mm = 1e3;
    grab.force_limit_un = 1e4;
    return grab;
}

TEST_P(StepperInput, RefusesABodyThatDoesNotFit) {
    const std::function<void(BodyDescription&)> faults[] = {
        [](BodyDescription& b) {
            b.mesh.vertices_mm.emplace_back(100, 0, 0);
            b.fixed.push_back(0);
        },
        [](BodyDescription& b) { b.fixed.pop_back(); },
        [](BodyDescription& b) { b.stiffness_factor = {1.0}; },
        [](BodyDescription& b) { b.stiffness_factor.assign(b.mesh.tetrahedra.size(), 0.0); },
        [](BodyDescription& b) { b.stiffness_factor.assign(b.mesh.tetrahedra.size(), -1.0); },
        [](BodyDescription& b) { b.stiffness_factor.assign(b.mesh.tetrahedra.size(), HUGE_VAL); },
        [](BodyDescription& b) { b.density_factor.assign(b.mesh.tetrahedra.size(), nan); },
        [](BodyDescription& b) { b.tether_pa_per_mm2 = nan; },
        [](BodyDescription& b) { b.mesh.tetrahedra.clear(); },
        [](BodyDescription& b) { b.material.young_modulus_pa = -1.0; },
        [](BodyDescription& b) { b.self = SelfPad{.thickness_edges = 0.0}; },
        [](BodyDescription& b) { b.self = SelfPad{.thickness_edges = nan}; },
        [](BodyDescription& b) { b.self = SelfPad{.pressure_moduli = -1.0}; },
        [](BodyDescription& b) { b.self = SelfPad{.pressure_moduli = HUGE_VAL}; },
        [](BodyDescription& b) { b.self = SelfPad{.friction = nan}; },
    };
    for (std::size_t f = 0; f < std::size(faults); ++f) {
        BodyDescription body = bar_body();
        faults[f](body);
        EXPECT_THROW(GetParam()(body, {}), InputError) << "fault " << f;
    }
}

TEST_P(StepperInput, RefusesOptionsOutOfRangeEvenAsleep) {
    const std::function<void(StepperOptions&)> faults[] = {
        [](StepperOptions& o) { o.linear.energy_tolerance = nan; },
        [](StepperOptions& o) { o.linear.energy_tolerance = -1e-3; },
        [](StepperOptions& o) { o.linear.energy_tolerance = HUGE_VAL; },
        [](StepperOptions& o) { o.linear.residual_tolerance = nan; },
        [](StepperOptions& o) { o.linear.residual_tolerance = -1e-9; },
        [](StepperOptions& o) { o.linear.residual_tolerance = HUGE_VAL; },
        [](StepperOptions& o) { o.linear.max_iterations = 0; },
        [](StepperOptions& o) { o.newton_iterations = 0; },
        [](StepperOptions& o) { o.newton_tolerance = nan; },
        [](StepperOptions& o) { o.newton_tolerance = 0.0; },
        [](StepperOptions& o) { o.newton_tolerance = HUGE_VAL; },
        [](StepperOptions& o) { o.substeps = 0; },
        [](StepperOptions& o) { o.swing_substeps = 0; },
        [](StepperOptions& o) { o.velocity_error.alpha_per_s = nan; },
        [](StepperOptions& o) { o.velocity_error.beta_s = HUGE_VAL; },
    };
    const auto stepper = asleep();
    for (std::size_t f = 0; f < std::size(faults); ++f) {
        StepperOptions options;
        faults[f](options);
        EXPECT_THROW(make(options), InputError) << "fault " << f;
        EXPECT_THROW(stepper->set_options(options), InputError) << "fault " << f;
    }
    EXPECT_TRUE(stepper->step(frame_s).asleep);
}

TEST_P(StepperInput, TakesOptionsOnTheirBounds) {
    StepperOptions options;
    options.linear = {.energy_tolerance = 0.0, .residual_tolerance = 0.0, .max_iterations = 1};
    options.newton_tolerance = 1e-300;
    options.velocity_error = {.alpha_per_s = -1e9, .beta_s = -1e9};
    EXPECT_NO_THROW(make(options));
}

TEST_P(StepperInput, RefusesAClockThatDoesNotAdvanceEvenAsleep) {
    const auto awake = make(), resting = asleep();
    for (const double dt : {0.0, -frame_s, nan, HUGE_VAL}) {
        EXPECT_THROW(awake->step(dt), InputError) << dt;
        EXPECT_THROW(resting->step(dt), InputError) << dt;
    }
}

TEST_P(StepperInput, RefusedGrabsGravityAndStatesLeaveItAsItWas) {
    const std::function<void(Grab&)> faults[] = {
        [](Grab& g) { g.vertices[0] = 100000; },      [](Grab& g) { g.vertices[0] = -1; },
        [](Grab& g) { g.vertices[1] = 100000; },      [](Grab& g) { g.weights[0] = nan; },
        [](Grab& g) { g.weights[0] = 0.5; },          [](Grab& g) { g.target_mm.y() = nan; },
        [](Grab& g) { g.stiffness_un_per_mm = 0.0; }, [](Grab& g) { g.force_limit_un = HUGE_VAL; },
    };
    const auto stepper = asleep(), other = asleep();
    const std::vector<Vec3> rest = bar_body().mesh.vertices_mm;
    const std::vector<Vec3> still(rest.size(), Vec3::Zero()), wrong(rest.size(), Vec3(0, nan, 0));
    for (std::size_t f = 0; f < std::size(faults); ++f) {
        Grab grab = some_grab();
        faults[f](grab);
        EXPECT_THROW(stepper->set_grabs(std::span(&grab, 1)), InputError) << "fault " << f;
    }
    EXPECT_THROW(stepper->set_gravity(Vec3(0, nan, 0)), InputError);
    EXPECT_THROW(stepper->set_state(wrong, still), InputError);
    EXPECT_THROW(stepper->set_state(rest, wrong), InputError);
    EXPECT_THROW(stepper->set_state(rest, {}), InputError);
    EXPECT_TRUE(stepper->step(frame_s).asleep);
    other->step(frame_s);
    // What is done next begins from the same state, with the same forces.
    for (Stepper* s : {stepper.get(), other.get()}) {
        s->set_gravity(Vec3(0, 9810, 0));
        for (int k = 0; k < 5; ++k) s->step(frame_s);
    }
    for (std::size_t v = 0; v < rest.size(); ++v)
        EXPECT_EQ(stepper->positions_mm()[v], other->positions_mm()[v]);
}

INSTANTIATE_TEST_SUITE_P(
    BackEnds, StepperInput,
    testing::Values(Make{make_cpu_stepper},
                    Make{[](const BodyDescription& body,
                            const StepperOptions& options) -> std::unique_ptr<Stepper> {
                        return make_live_stepper(body, options);
                    }}),
    [](const auto& backend) { return backend.index == 0 ? "Whole" : "Live"; });

}  // namespace
}  // namespace hepatica
