// SPDX-License-Identifier: GPL-3.0-or-later
// Tools of several capsules in the steps of a body: jaws hold up to Coulomb's limit and slip beyond
// it, exchange momentum with what they lift, and pass through nothing; a hook holds aside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/frame_time.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/tool_oracles.h"

namespace hepatica {
namespace {

using test::bar;
using test::ends_inside;
using test::free_brick;
using test::least_gap;
using test::momentum;

// Two rods along `axis_mm` that open along z, about a middle.
Tool jaws_at(const Vec3& middle_mm, const Vec3& half_axis_mm, double radius_mm, double opening_mm) {
    Tool tool;
    for (const double side : {-0.5, 0.5})
        tool.parts.push_back(
            {.shape = {.centre_mm =
                           middle_mm + side * (opening_mm + 2.0 * radius_mm) * Vec3::UnitZ(),
                       .half_axis_mm = half_axis_mm,
                       .radius_mm = radius_mm},
             .opens = side * Vec3::UnitZ()});
    tool.opening_mm = tool.opening_target_mm = opening_mm;
    tool.target_mm = tool.centre_mm();
    tool.pad_mm = 0.2;
    tool.pressure_pa = 2e6;
    tool.friction = 0.3;
    return tool;
}

// The bar, but with a free end, held there between wide jaws, which press it by a given way.
class Pinch {
  public:
    Pinch() {
        BodyDescription body = bar();
        for (std::size_t v = 0; v < body.fixed.size(); ++v)
            body.fixed[v] = body.mesh.vertices_mm[v][0] == 0.0;
        stepper_ = make_cpu_stepper(body, {.linear = {.energy_tolerance = 1e-9},
                                           .newton_iterations = 8,
                                           .newton_tolerance = 1e-9,
                                           .sleeping = false});
        stepper_->set_tool(jaws_at(Vec3(50, 3, 3), Vec3(0, 6, 0), 12.0, 7.0));
        stepper_->open_tool(6.0);
        run(60);
    }
    StepReport run(int steps, const Vec3& by_mm = Vec3::Zero()) {
        StepReport last;
        for (int k = 0; k < steps; ++k) {
            stepper_->lead_tool(stepper_->tool()->target_mm + by_mm);
            last = stepper_->step(frame_s);
        }
        return last;
    }
    Stepper& stepper() { return *stepper_; }
    // The mean place along the bar of the vertices that were under the jaws' middle.
    double held_mm() const {
        double sum = 0.0;
        int count = 0;
        for (std::size_t v = 0; v < rest_.size(); ++v)
            if (std::abs(rest_[v].x() - 51.0) < 1e-9) {
                sum += stepper_->positions_mm()[v].x();
                ++count;
            }
        return sum / count;
    }

  private:
    std::vector<Vec3> rest_ = bar().mesh.vertices_mm;
    std::unique_ptr<Stepper> stepper_;
};

// The grip is the lesser of the two normal forces, which are equal here; friction bears mu times
// their sum.
double limit_un(const StepReport& report) {
    return 0.3 * 2.0 * report.tool.grip_un;
}

TEST(ToolJaws, HoldAPullBelowTheirFriction) {
    Pinch pinch;
    StepReport last = pinch.run(1);
    ASSERT_GT(last.tool.grip_un, 1e3);
    EXPECT_LT(std::abs(last.tool.force_un.x()), 0.2 * limit_un(last));
    while (-last.tool.force_un.x() < 0.7 * limit_un(last)) last = pinch.run(1, Vec3(0.002, 0, 0));
    // What is held has come along, and stays for ten seconds.
    const double led = pinch.stepper().tool()->centre_mm().x() - 50.0;
    const double held = pinch.held_mm();
    EXPECT_GT(led, 0.02);
    EXPECT_NEAR(held - 51.0, led, 0.4 * led);
    last = pinch.run(600);
    EXPECT_NEAR(pinch.held_mm(), held, 0.05 * led);
    EXPECT_GT(-last.tool.force_un.x(), 0.6 * limit_un(last));
}

TEST(ToolJaws, SlipWhereThePullIsStrongerThanTheirFriction) {
    Pinch pinch;
    pinch.run(100, Vec3(0.015, 0, 0));
    const double held = pinch.held_mm(), tool = pinch.stepper().tool()->centre_mm().x();
    // Over an edge of the mesh, after which the surface is the same again.
    constexpr int steps = 200;
    double pull = 0.0, limit = 0.0;
    for (int k = 0; k < steps; ++k) {
        const StepReport report = pinch.run(1, Vec3(0.015, 0, 0));
        pull -= report.tool.force_un.x();
        limit += limit_un(report);
    }
    EXPECT_NEAR(pull / limit, 1.0, 0.03);
    // The jaws have gone on by three millimetres, what was between them by much less.
    EXPECT_NEAR(pinch.stepper().tool()->centre_mm().x() - tool, 3.0, 1e-6);
    EXPECT_LT(std::abs(pinch.held_mm() - held), 1.0);
}

// Led across themselves jaws take along what they hold, as fast as a hand goes, and the force on
// them is that of what they bend.
TEST(ToolJaws, TakeWhatTheyHoldAlongAcrossThemselves) {
    BodyDescription body;
    body.mesh = kuhn_brick(Vec3(40, 4, 4), {20, 2, 2});
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.x() < 0.1);
    body.touchable = true;
    const auto stepper = make_cpu_stepper(body, {});
    Tool jaws = jaws_at(Vec3(30, 2, 2), Vec3(0, 15, 0), 2.0, 12.0);
    jaws.pad_mm = 0.5;
    jaws.friction = 0.6;
    jaws.force_limit_un = 2.5e6;
    stepper->set_tool(jaws);
    stepper->open_tool(0.0);
    for (int k = 0; k < 120; ++k) stepper->step(frame_s);
    const Vec3 from = stepper->tool()->centre_mm();
    constexpr double way_mm = 8.0;
    double hardest_un = 0.0;
    for (int k = 1; k <= 90; ++k) {
        stepper->lead_tool(from + std::min(1.0, k / 60.0) * way_mm * Vec3::UnitZ());
        const StepReport report = stepper->step(frame_s);
        hardest_un = std::max(hardest_un, report.tool.force_un.norm());
        EXPECT_GT(report.tool.grip_un, 1e6) << k;
    }
    EXPECT_NEAR(stepper->tool()->centre_mm().z() - from.z(), way_mm, 0.1);
    EXPECT_LT(hardest_un, 1.5 * jaws.force_limit_un);
    // What they hold has gone along.
    const auto& rest = body.mesh.vertices_mm;
    const auto held = static_cast<std::size_t>(
        std::ranges::find_if(rest,
                             [](const Vec3& x) { return (x - Vec3(30, 2, 2)).norm() < 0.1; }) -
        rest.begin());
    EXPECT_NEAR(stepper->positions_mm()[held].z() - rest[held].z(), way_mm, 0.1 * way_mm);
}

// A free brick is taken, lifted and let go: all its momentum is the tool's.
TEST(ToolJaws, LiftWithTheMomentumThatTheyGive) {
    const BodyDescription description = free_brick();
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    const auto stepper = make_cpu_stepper(description, {.linear = {.energy_tolerance = 1e-10},
                                                        .newton_iterations = 30,
                                                        .newton_tolerance = 1e-12});
    stepper->set_tool(jaws_at(Vec3(6, 4, 4), Vec3(0, 4, 0), 3.0, 10.0));
    Vec3 before = momentum(*stepper, body);
    int good = 0;
    for (int k = 0; k < 120; ++k) {
        if (k < 40) stepper->open_tool(10.0 - 0.07 * k);
        const double share = std::clamp(0.05 * (k - 40), 0.0, 1.0);
        if (k < 110) stepper->lead_tool(stepper->tool()->target_mm + share * Vec3(0.05, 0.1, 0.02));
        if (k == 100) stepper->open_tool(12.0);
        const StepReport report = stepper->step(frame_s);
        const Vec3 now = momentum(*stepper, body);
        const Vec3 gained = now - before;
        before = now;
        if (report.degraded || report.newton_iterations >= 30 || report.tool.contacts == 0)
            continue;
        ++good;
        // Of both jaws' impulses, which nearly cancel.
        EXPECT_LT((gained + report.tool.impulse_un_s).norm(),
                  1e-8 * 2.0 * report.tool.grip_un * frame_s)
            << k;
    }
    EXPECT_GT(good, 50);
    // It flies on as it was led.
    const double mass = [&] {
        double sum = 0.0;
        for (const double m : body.mass_g) sum += m;
        return sum;
    }();
    EXPECT_NEAR(before.y() / mass, 0.1 / frame_s, 0.02 * 0.1 / frame_s);
}

// Opened, closed, turned and led through the bar at 0.01 to 100 m/s.
TEST(ToolJaws, PassThroughNothingAtAnySpeed) {
    const BodyDescription body = bar();
    const SurfacePatches surface(boundary_triangles(body.mesh));
    std::mt19937_64 random(6);
    const auto in = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
    };
    int held = 0;
    for (const double speed_mm_per_s : {10.0, 100.0, 1e3, 1e4, 1e5}) {
        const auto stepper = make_cpu_stepper(body, {});
        Tool tool = jaws_at(Vec3(30, 0, 3), Vec3(in(-1, 1), 5, 0), 1.2, 9.0);
        tool.force_limit_un = 3e6;
        stepper->set_tool(tool);
        for (int k = 0; k < 90; ++k) {
            if (k % 15 == 0) stepper->open_tool(k % 30 == 0 ? 0.0 : 9.0);
            if (k % 7 == 0) stepper->turn_tool(Vec3(in(-0.4, 0.4), in(-0.4, 0.4), in(-0.4, 0.4)));
            const Vec3 way =
                Vec3(in(20, 40), in(-4, 10), in(-6, 12)) - stepper->tool()->centre_mm();
            stepper->lead_tool(stepper->tool()->centre_mm() +
                               std::min(1.0, speed_mm_per_s * frame_s / way.norm()) * way);
            const StepReport report = stepper->step(frame_s);
            held += report.tool.grip_un > 0.0 ? 1 : 0;
            ASSERT_GT(least_gap(*stepper, surface), 0.0) << speed_mm_per_s << " mm/s, " << k;
            ASSERT_FALSE(ends_inside(*stepper, body.mesh)) << speed_mm_per_s << " mm/s, " << k;
            for (const Vec3& x : stepper->positions_mm()) ASSERT_TRUE(x.allFinite());
        }
        // The jaws are still as they were to each other.
        const Tool now = *stepper->tool();
        const Vec3 apart = now.parts[1].shape.centre_mm - now.parts[0].shape.centre_mm;
        EXPECT_NEAR(apart.norm(), now.opening_mm + 2.4, 1e-9);
        EXPECT_NEAR((now.parts[1].opens - now.parts[0].opens).norm(), 1.0, 1e-9);
    }
    EXPECT_GT(held, 50);
}

// A brick that flies against either of two balls, far apart, in steps longer than itself.
TEST(ToolJaws, WhatFliesIsStoppedByEachPart) {
    const BodyDescription description = free_brick();
    const SurfacePatches surface(boundary_triangles(description.mesh));
    const std::size_t vertices = description.mesh.vertices_mm.size();
    for (const bool second : {false, true})
        for (const double speed_mm_per_s : {1e3, 1e4, 1e5}) {
            const auto stepper = make_cpu_stepper(description, {});
            Tool tool;
            for (const bool hit : {!second, second})
                tool.parts.push_back(
                    {.shape = {.centre_mm = Vec3(hit ? 6.3 : 90.0, 4.2, -6), .radius_mm = 4.0}});
            tool.target_mm = tool.centre_mm();
            tool.pad_mm = 0.4;
            tool.pressure_pa = 2e6;
            stepper->set_tool(tool);
            stepper->set_state(description.mesh.vertices_mm,
                               std::vector<Vec3>(vertices, Vec3(0, 0, -speed_mm_per_s)));
            for (int k = 0; k < 5; ++k) {
                stepper->step(frame_s);
                ASSERT_GT(least_gap(*stepper, surface), 0.0);
                ASSERT_FALSE(ends_inside(*stepper, description.mesh));
                // The middle of the brick has not come past that of the ball on its way.
                if (k == 0) {
                    ASSERT_GT(stepper->positions_mm()[vertices / 2].z(), -6.0) << speed_mm_per_s;
                }
            }
        }
}

// They do not close against more than their limit.
TEST(ToolJaws, CloseUntilTheirForce) {
    BodyDescription body = bar();
    body.tether_pa_per_mm2 = 20.0;  // of tissue, in which what is held comes to rest
    const auto stepper = make_live_stepper(body, {});
    Tool tool = jaws_at(Vec3(30, 3, 3), Vec3(0, 6, 0), 2.0, 8.0);
    tool.force_limit_un = 1e6;
    stepper->set_tool(tool);
    stepper->open_tool(0.0);
    StepReport last;
    for (int k = 0; k < 600; ++k) {
        last = stepper->step(frame_s);
        EXPECT_FALSE(last.shortened) << k << ": where they begin to hold, friction turns";
    }
    EXPECT_GT(last.tool.grip_un, 0.8e6);
    EXPECT_LT(last.tool.grip_un, 1.02e6);
    EXPECT_LT(stepper->tool()->opening_mm, 6.2);
    EXPECT_TRUE(last.asleep) << "what is held rests";
    EXPECT_LT(last.tool.force_un.norm(), 0.05e6) << "both jaws press alike";
}

// A shaft beside the bar and a foot below it, led sideways and up.
TEST(ToolHook, HoldsABarAsideAndLetsItGo) {
    const BodyDescription body = bar();
    const SurfacePatches surface(boundary_triangles(body.mesh));
    const auto stepper = make_cpu_stepper(body, {});
    Tool hook;
    hook.parts.push_back(
        {.shape = {
             .centre_mm = Vec3(30, -2.5, 5), .half_axis_mm = Vec3(0, 0, -7), .radius_mm = 1.0}});
    hook.parts.push_back(
        {.shape = {
             .centre_mm = Vec3(30, 1.5, -2), .half_axis_mm = Vec3(0, 4, 0), .radius_mm = 1.0}});
    hook.target_mm = hook.centre_mm();
    hook.pad_mm = 0.2;
    hook.pressure_pa = 2e6;
    hook.friction = 0.2;
    stepper->set_tool(hook);
    const auto middle = [&] {
        Vec3 sum = Vec3::Zero();
        int count = 0;
        for (std::size_t v = 0; v < body.mesh.vertices_mm.size(); ++v)
            if (std::abs(body.mesh.vertices_mm[v].x() - 30.0) < 1e-9) {
                sum += stepper->positions_mm()[v];
                ++count;
            }
        return Vec3(sum / count);
    };
    StepReport last;
    for (int k = 0; k < 60; ++k) {
        stepper->lead_tool(stepper->tool()->target_mm + Vec3(0, 0.05, 0.06));
        last = stepper->step(frame_s);
        ASSERT_GT(least_gap(*stepper, surface), 0.0) << k;
    }
    EXPECT_GT(middle().y() - 3.0, 0.8);
    EXPECT_GT(middle().z() - 3.0, 0.8);
    EXPECT_LT(last.tool.force_un.y(), 0.0);
    EXPECT_LT(last.tool.force_un.z(), 0.0);
    for (int k = 0; k < 1200; ++k) last = stepper->step(frame_s);
    EXPECT_TRUE(last.asleep);
    EXPECT_GT(middle().y() - 3.0, 0.8) << "held aside";
    for (int k = 0; k < 60; ++k) {
        stepper->lead_tool(stepper->tool()->target_mm - Vec3(0, 0.2, 0.3));
        stepper->step(frame_s);
    }
    for (int k = 0; k < 300; ++k) last = stepper->step(frame_s);
    EXPECT_EQ(last.tool.contacts, 0);
    EXPECT_LT((middle() - Vec3(30, 3, 3)).norm(), 0.01);
}

// With a pinched bar, through bytes.
TEST(ToolJaws, ARestoredStepperGoesOnToTheLastBit) {
    const auto play = [](Stepper& stepper, int k) {
        if (k == 0) stepper.set_tool(jaws_at(Vec3(30, 3, 3), Vec3(0, 6, 0), 2.0, 8.0));
        if (k == 5) stepper.open_tool(5.5);
        if (k > 20) stepper.lead_tool(Vec3(30 + 0.03 * k, 3, 3 + 0.05 * k));
        if (k == 30) stepper.turn_tool(Vec3(0.1, 0.2, 0));
        stepper.step(frame_s);
    };
    const auto first = make_cpu_stepper(bar(), {}), second = make_cpu_stepper(bar(), {});
    std::string bytes;
    for (int k = 0; k < 60; ++k) {
        play(*first, k);
        if (k == 32) bytes = to_bytes(first->checkpoint());
    }
    second->restore(checkpoint_from_bytes(bytes));
    for (int k = 33; k < 60; ++k) play(*second, k);
    EXPECT_EQ(second->state_hash(), first->state_hash());
    EXPECT_GT(first->tool_load().grip_un, 0.0);
}

}  // namespace
}  // namespace hepatica
