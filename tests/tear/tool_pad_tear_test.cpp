// SPDX-License-Identifier: GPL-3.0-or-later
// What tears within a tool's pad: the faces that are new there store nothing at once, and press
// back like all others once they have been away.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/base/frame_time.h"
#include "core/contact/surface_patches.h"
#include "core/deform/potentials/thin_pads.h"
#include "core/deform/potentials/tool_pad.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/tear/tearing.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

constexpr double top_mm = 2.0;

// A bar along x, fixed at its bottom, that tears only where a blade passes.
BodyDescription bar_to_cut() {
    BodyDescription body;
    test::add_mesh(test::bar_at({24, 4, 4}, {12, 2, 2}, Mat3::Identity(), Vec3::Zero()), body.mesh);
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.z() < -1.9);
    body.touchable = true;
    body.tear.emplace();
    body.tear->tear_factor = 1e3;
    return body;
}

Tool ball_above(double gap_mm) {
    Tool ball = single_tool({Vec3(0.4, 0.1, top_mm + 2.0 + gap_mm), Vec3::Zero(), 2.0});
    ball.pad_mm = 0.5;
    ball.pressure_pa = 5e3;
    return ball;
}

void lead_to(Stepper& stepper, double gap_mm, int steps) {
    stepper.lead_tool(ball_above(gap_mm).centre_mm());
    for (int k = 0; k < steps; ++k) stepper.step(frame_s);
}

// A stepper whose ball is pressed onto the bar, which is cut across below it.
std::unique_ptr<Stepper> pressed_and_cut(const BodyDescription& body) {
    auto stepper = make_cpu_stepper(body, {});
    stepper->set_tool(ball_above(1.0));
    lead_to(*stepper, -0.3, 40);
    stepper->cut(Vec3(0.3, -20, 0.5), Vec3(0, 40, 0), Vec3(0, 0, 20));
    return stepper;
}

TEST(ToolPadTear, ACutInThePadStoresNothing) {
    const BodyDescription body = bar_to_cut();
    const auto stepper = make_cpu_stepper(body, {});
    stepper->set_tool(ball_above(1.0));
    lead_to(*stepper, -0.3, 40);
    const double before = stepper->energies().contact;
    ASSERT_GT(before, 0.0);
    stepper->cut(Vec3(0.3, -20, 0.5), Vec3(0, 40, 0), Vec3(0, 0, 20));
    ASSERT_GT(stepper->tearing()->report().vertices_split, 0);
    ASSERT_FALSE(stepper->tool()->thin_pads.empty()) << "no new face lies in the pad";
    EXPECT_NEAR(stepper->energies().contact, before, 1e-12 * before);
    // A second cut beside it keeps what is thin, although its corners have other numbers now.
    const auto thin = stepper->tool()->thin_pads.size();
    const double between = stepper->energies().contact;
    stepper->cut(Vec3(-20, 0.3, 0.5), Vec3(40, 0, 0), Vec3(0, 0, 20));
    EXPECT_GT(stepper->tool()->thin_pads.size(), thin);
    EXPECT_NEAR(stepper->energies().contact, between, 1e-12 * between);
}

TEST(ToolPadTear, ThinPadsHoldTheToolOutAndGrowWithTheGap) {
    const BodyDescription body = bar_to_cut();
    const auto stepper = pressed_and_cut(body);
    for (int k = 0; k < 60; ++k) {
        const StepReport report = stepper->step(frame_s);
        ASSERT_GT(report.tool.least_gap_mm, 0.0) << k;
        for (const ThinPad& thin : stepper->tool()->thin_pads) {
            ASSERT_GT(thin.pad_mm, 0.0);
            ASSERT_LT(thin.pad_mm, stepper->tool()->pad_mm);
        }
    }
    lead_to(*stepper, 3.0, 120);
    EXPECT_TRUE(stepper->tool()->thin_pads.empty());
    EXPECT_EQ(stepper->energies().contact, 0.0);
}

TEST(ToolPadTear, ACheckpointHoldsThinPads) {
    const BodyDescription body = bar_to_cut();
    const auto stepper = pressed_and_cut(body);
    lead_to(*stepper, -0.6, 3);
    ASSERT_FALSE(stepper->tool()->thin_pads.empty());
    const auto other = make_cpu_stepper(body, {});
    other->restore(checkpoint_from_bytes(to_bytes(stepper->checkpoint())));
    EXPECT_EQ(other->state_hash(), stepper->state_hash());
    EXPECT_EQ(other->energies().contact, stepper->energies().contact);
    for (int k = 0; k < 20; ++k) {
        stepper->step(frame_s);
        other->step(frame_s);
        ASSERT_EQ(other->state_hash(), stepper->state_hash()) << k;
    }
}

// Two balls of a tool over a bare triangle, in either order: the nearer one says how thin its pad
// is, and how far it grows. Another triangle lies below the second ball alone.
TEST(ToolPadTear, OfTwoPartsTheNearerOneSaysHowThinAPadIs) {
    const SurfacePatches surface({{0, 1, 2}, {3, 4, 5}});
    std::vector<Vec3> x{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 3, 0.1}, {2, 3, 0.1}, {0, 5, 0.1}};
    const std::vector<int> same_nodes{0, 1, 2, 3, 4, 5};
    const auto ball = [](const Vec3& at_mm) {
        return single_tool({at_mm, Vec3::Zero(), 1.0}).parts.front();
    };
    for (const bool nearer_first : {true, false}) {
        Tool jaws = ball_above(0.0);
        jaws.parts = {ball({0.5, 0.5, 1.2}), ball({0.5, 1.2, 1.3})};
        jaws.parts.push_back(ball({0.5, 3.5, 1.4}));
        if (!nearer_first) std::swap(jaws.parts[0], jaws.parts[1]);
        jaws.thin_pads = thin_pads_after_split({}, jaws, surface, same_nodes, x);
        ASSERT_EQ(jaws.thin_pads.size(), 2u);
        const double whole = 1.0 + ToolPad::dip_of_pad;
        EXPECT_NEAR(pad_of_triangle_mm(jaws, {2, 0, 1}), 0.2 / whole, 1e-12);
        EXPECT_NEAR(pad_of_triangle_mm(jaws, {3, 4, 5}), 0.3 / whole, 1e-12);
        for (std::size_t v = 0; v < 3; ++v) x[v].z() -= 0.1;
        grow_thin_pads(jaws, surface, x);
        EXPECT_NEAR(pad_of_triangle_mm(jaws, {0, 1, 2}), 0.3 / whole, 1e-12);
        EXPECT_NEAR(pad_of_triangle_mm(jaws, {3, 4, 5}), 0.3 / whole, 1e-12);
        for (std::size_t v = 0; v < 3; ++v) x[v].z() += 0.1;
    }
}

}  // namespace
}  // namespace hepatica
