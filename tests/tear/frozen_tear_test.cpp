// SPDX-License-Identifier: GPL-3.0-or-later
// A blade in a part of the body that is frozen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/frame_time.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/mesh/brick_mesh.h"
#include "core/tear/tearing.h"

namespace hepatica {
namespace {

constexpr double plane_mm = 10.0, stretch = 1.06;

// A clamped bar of 20 mm.
BodyDescription clamped_bar() {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(20, 4, 4), {10, 2, 2});
    body.material.young_modulus_pa = 0.5e6;
    body.material.poisson_ratio = 0.3;
    body.tear = TearLaw{.strength_pa = 2e4, .fracture_energy_j_m2 = 60.0};
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.x() < 1e-9);
    return body;
}

// All joints but those in the plane hold whatever pulls at them; how many are in the plane.
std::size_t hold_beside_the_plane(Stepper& stepper) {
    const auto joints = stepper.tearing()->topology().joints();
    std::vector<int> others;
    for (std::size_t j = 0; j < joints.size(); ++j)
        if (std::abs(joints[j].centre_mm.x() - plane_mm) > 1e-9)
            others.push_back(static_cast<int>(j));
    stepper.weaken(others, 1e6);
    return joints.size() - others.size();
}

// What has begun to tear and freezes before it is cut springs apart. The cut splits no vertex: all
// of the plane has been split before, and is bound by ties alone.
TEST(FrozenTear, ABladeThroughTiesWakesWhatTheyHeld) {
    const BodyDescription body = clamped_bar();
    // Whatever is not held freezes after every step.
    const auto stepper = make_live_stepper(body, {}, {.still_s = 0.0});
    const std::size_t in_plane = hold_beside_the_plane(*stepper);
    std::vector<Vec3> strained = body.mesh.vertices_mm;
    for (Vec3& x : strained) x.x() *= stretch;
    stepper->set_state(strained, std::vector<Vec3>(strained.size(), Vec3::Zero()));
    stepper->step(1e-6);
    const Tearing& tearing = *stepper->tearing();
    ASSERT_EQ(tearing.ties().size(), 3 * in_plane);
    ASSERT_EQ(tearing.report().pieces, 1);
    ASSERT_TRUE(stepper->step(frame_s).asleep);
    const std::vector<Vec3> before(stepper->positions_mm().begin(), stepper->positions_mm().end());

    stepper->cut(Vec3(stretch * (plane_mm + 0.1), -5, -5), Vec3(0, 14, 0), Vec3(0, 0, 14));
    ASSERT_EQ(tearing.report().pieces, 2);
    ASSERT_TRUE(tearing.ties().empty());
    ASSERT_EQ(stepper->positions_mm().size(), before.size());
    EXPECT_FALSE(stepper->step(frame_s).asleep);
    double most = 0.0;
    for (std::size_t v = 0; v < before.size(); ++v)
        most = std::max(most, (stepper->positions_mm()[v] - before[v]).norm());
    EXPECT_GT(most, 0.1);
}

}  // namespace
}  // namespace hepatica
