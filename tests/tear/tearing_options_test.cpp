// SPDX-License-Identifier: GPL-3.0-or-later
// What tears after another element model was chosen.
#include <gtest/gtest.h>

#include <vector>

#include "core/base/frame_time.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {

// A bar between two walls, drawn out evenly to twice its length, of which a held part is live. The
// new model's stress is above the strength everywhere, that of the model before is not: what is
// frozen tears at once as well, as in a stepper that goes on from a checkpoint.
TEST(TearingOptions, WhatIsFrozenTearsByTheElementModelThatWasChosen) {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(100, 4, 4), {25, 1, 1});
    body.material.damping_ratio = 1.0;
    body.material.poisson_ratio = 0.0;
    body.tear = TearLaw{.strength_pa = 4.93e5};
    std::vector<Vec3> drawn_out = body.mesh.vertices_mm;
    int middle = 0;
    for (std::size_t v = 0; v < drawn_out.size(); ++v) {
        body.fixed.push_back(drawn_out[v].x() == 0.0 || drawn_out[v].x() == 100.0);
        if (drawn_out[v] == Vec3(48, 4, 4)) middle = static_cast<int>(v);
        drawn_out[v].x() *= 2.0;
    }
    StepperOptions options{.model = ElementModel::neohookean, .linear = {.energy_tolerance = 1e-8}};
    const LiveRegionOptions region{.still_s = 0.1};
    const auto went_on = make_live_stepper(body, options, region);
    went_on->set_state(drawn_out, std::vector<Vec3>(drawn_out.size(), Vec3::Zero()));
    Grab grab{.vertices = {middle, -1, -1, -1}};
    grab.target_mm = drawn_out[middle];
    grab.stiffness_un_per_mm = 1e3;
    grab.force_limit_un = 1e6;
    went_on->set_grabs(std::span(&grab, 1));
    const auto all_live = [&] {
        return went_on->extent().live_elements == went_on->extent().elements;
    };
    for (int k = 0; k < 120 && all_live(); ++k) went_on->step(frame_s);
    ASSERT_FALSE(all_live());
    ASSERT_EQ(went_on->tearing()->report().vertices_split, 0);
    options.model = ElementModel::corotated;
    ASSERT_TRUE(went_on->set_options(options));
    const auto restored = make_live_stepper(body, options, region);
    restored->restore(went_on->checkpoint());
    for (Stepper* stepper : {went_on.get(), restored.get()}) stepper->step(frame_s);
    EXPECT_GT(restored->tearing()->report().vertices_split, 300);
    EXPECT_EQ(went_on->tearing()->report().vertices_split,
              restored->tearing()->report().vertices_split);
    EXPECT_EQ(went_on->state_hash(), restored->state_hash());
}

}  // namespace
}  // namespace hepatica
