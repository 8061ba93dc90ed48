// SPDX-License-Identifier: GPL-3.0-or-later
// A tool beside obstacles: it enters no tumour and does not leave the liver that it lies in, at any
// speed; it slides along them, and knows the force with which they press on it.
#include "core/deform/potentials/tool_obstacle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/frame_time.h"
#include "core/deform/potentials/potential_list.h"
#include "core/deform/stepper/cpu_stepper.h"
#include "core/deform/stepper/live_stepper.h"
#include "tests/deform/support/obstacle_shapes.h"
#include "tests/deform/support/tool_oracles.h"

namespace hepatica {
namespace {

using test::ball_surface;
using test::bar;
using test::box_surface;
using test::one_obstacle;
using test::winding;

Tool with_pad(Tool tool, const Vec3& at_mm) {
    for (ToolPart& part : tool.parts) part.shape.centre_mm += at_mm;
    tool.target_mm = tool.centre_mm();
    tool.pad_mm = 0.4;
    tool.pressure_pa = 2e6;
    tool.friction = 0.3;
    return tool;
}

Tool probe_at(const Vec3& at_mm, double radius_mm = 2.0) {
    return with_pad(single_tool({.radius_mm = radius_mm}), at_mm);
}

Tool rod_probe_at(const Vec3& at_mm, const Vec3& half_axis_mm = Vec3(5, 2, -1)) {
    return with_pad(single_tool({.half_axis_mm = half_axis_mm, .radius_mm = 0.8}), at_mm);
}

Tool hook_beside(const Vec3& at_mm) {
    Tool hook = single_tool({.half_axis_mm = Vec3(0, 0, 6), .radius_mm = 0.7});
    hook.parts.push_back(
        {.shape = {.centre_mm = Vec3(2, 0, -6), .half_axis_mm = Vec3(2, 0, 0), .radius_mm = 0.7}});
    return with_pad(hook, at_mm);
}

Tool open_jaws_at(const Vec3& at_mm, double opening_mm) {
    Tool jaws;
    for (const double side : {-0.5, 0.5})
        jaws.parts.push_back({.shape = {.centre_mm = side * Vec3(opening_mm + 2.0, 0, 0),
                                        .half_axis_mm = Vec3(0, 0, 5),
                                        .radius_mm = 1.0},
                              .opens = side * Vec3::UnitX()});
    jaws.opening_mm = jaws.opening_target_mm = opening_mm;
    return with_pad(jaws, at_mm);
}

// Far below the tool that is tried, but for tests that say otherwise.
BodyDescription bar_beside(std::shared_ptr<const Obstacles> obstacles) {
    BodyDescription body = bar();
    body.obstacles = std::move(obstacles);
    return body;
}

// To the nearest triangle; below 0 where it is in the tool, or the tool's axis in the obstacle.
double gap_to(const TriangleMesh& surface, const Tool& tool) {
    double least = INFINITY;
    for (const ToolPart& part : tool.parts) {
        for (const auto& triangle : surface.triangles)
            least = std::min(least, std::sqrt(closest(part.shape.axis(),
                                                      corners_of(triangle, surface.vertices_mm))
                                                  .squared_mm2) -
                                        part.shape.radius_mm);
        if (winding(surface, part.shape.centre_mm) > 0.5) return -part.shape.radius_mm;
    }
    return least;
}

double unlike(int k, int salt) {
    return 2.0 * std::fmod(0.61803398875 * (17 * k + salt), 1.0) - 1.0;
}

// Led to and fro through it and turned, at 0.01 to 100 m/s.
TEST(ToolBesideObstacles, WhatIsFlungAtATumourDoesNotEnterIt) {
    const Vec3 centre(30, 3, 40);
    const BodyDescription body = bar_beside(one_obstacle(ball_surface(centre, 6.0)));
    const TriangleMesh& tumour = body.obstacles->all[0].surface;
    const Vec3 beside = centre + Vec3(0, 0, 17);
    for (const Tool& tool :
         {probe_at(beside), rod_probe_at(beside), hook_beside(beside), open_jaws_at(beside, 3.0)}) {
        for (const double speed_mm_per_s : {10.0, 100.0, 1e3, 1e4, 1e5}) {
            const auto stepper = make_cpu_stepper(body, {});
            stepper->set_tool(tool);
            int met = 0;
            for (int k = 0; k < 120; ++k) {
                const Vec3 at = stepper->tool()->centre_mm();
                // Into it, through it, into it from the other side.
                const double height = std::array{0.0, -14.0, 0.0, 14.0}[k / 10 % 4];
                const Vec3 goal = centre + Vec3(2 * unlike(k, 1), 2 * unlike(k, 2), height);
                const Vec3 way = goal - at;
                stepper->lead_tool(at + std::min(1.0, speed_mm_per_s * frame_s / way.norm()) * way);
                stepper->turn_tool(0.1 * Vec3(unlike(k, 3), unlike(k, 4), unlike(k, 5)));
                if (tool.opening_mm > 0.0) stepper->open_tool(2.0 + 2.0 * unlike(k, 6));
                stepper->step(frame_s);
                const double gap = gap_to(tumour, *stepper->tool());
                ASSERT_GT(gap, 0.19) << speed_mm_per_s << " mm/s, step " << k;
                met += gap < 0.4 ? 1 : 0;
            }
            EXPECT_GT(met, 20) << speed_mm_per_s << " mm/s, " << tool.parts.size() << " parts";
        }
    }
}

// A slab as wide as the whole way: it stays on its side and slides along.
TEST(ToolBesideObstacles, SlidesAlongWhatStopsIt) {
    const BodyDescription body =
        bar_beside(one_obstacle(box_surface(Vec3(-100, -100, 40), Vec3(300, 300, 1), {6, 6, 1})));
    for (const double speed_mm_per_s : {10.0, 1e3, 1e5}) {
        const auto stepper = make_cpu_stepper(body, {});
        Tool tool = probe_at(Vec3(0, 0, 43.5));
        tool.force_limit_un = 100.0;
        stepper->set_tool(tool);
        const Vec3 end(60, 20, -30);
        for (int k = 0; k < 60; ++k) {
            stepper->lead_tool(tool.target_mm + std::min(1.0, speed_mm_per_s * frame_s * (k + 1) /
                                                                  (end - tool.target_mm).norm()) *
                                                    (end - tool.target_mm));
            stepper->step(frame_s);
            ASSERT_GT(stepper->tool()->centre_mm().z(), 41.0 + 2.0 + 0.19) << k;
        }
        if (speed_mm_per_s > 100.0) {
            EXPECT_LT((stepper->tool()->centre_mm() - Vec3(60, 20, 43.2)).norm(), 1e-2);
        }
    }
}

// With h the pad, R the radius and p the pressure, a ball whose gap to a plane is h/2 is pressed by
//   2 pi p h (R + h/2) (ln 2 - 1/2):
// the integral of p g/(1 - g) and the slope of the normal over rings of the plane.
TEST(ToolBesideObstacles, TheForceAtRestIsThatOfThePadInClosedForm) {
    const BodyDescription body =
        bar_beside(one_obstacle(box_surface(Vec3(27, -3, 39), Vec3(6, 6, 1), {60, 60, 6})));
    for (const bool region : {false, true}) {
        std::unique_ptr<Stepper> stepper;
        if (region)
            stepper = make_live_stepper(body, {});
        else
            stepper = make_cpu_stepper(body, {});
        Tool tool = probe_at(Vec3(30.1, 0.2, 50), 5.0);
        tool.pad_mm = 1.0;
        stepper->set_tool(tool);
        stepper->lead_tool(Vec3(30.1, 0.2, 30));
        StepReport last;
        for (int k = 0; k < 60 && !last.asleep; ++k) last = stepper->step(frame_s);
        EXPECT_TRUE(last.asleep);
        const double expected = 2.0 * M_PI * 2e6 * 1.0 * 5.5 * (std::log(2.0) - 0.5);
        const ToolLoad& load = stepper->tool_load();
        EXPECT_NEAR(load.force_un.z(), expected, 0.02 * expected) << region;
        EXPECT_LT(load.force_un.head<2>().norm(), 1e-3 * expected);
        EXPECT_LT(load.torque_un_mm.norm(), 1e-3 * expected);
        EXPECT_LT((load.at_mm - Vec3(30.1, 0.2, 40)).norm(), 0.02);
        EXPECT_NEAR(load.least_gap_mm, 0.5, 1e-3);
        // The body has nothing of it.
        EXPECT_EQ(load.contacts, 0);
        EXPECT_EQ(load.impulse_un_s, Vec3(Vec3::Zero()));
        EXPECT_EQ(stepper->energies().contact, 0.0);
        // Taken away, nothing presses any more.
        stepper->lead_tool(Vec3(30.1, 0.2, 60));
        stepper->step(frame_s);
        EXPECT_EQ(stepper->tool_load().force_un, Vec3(Vec3::Zero())) << region;
    }
}

double energy_of(const std::vector<PadContact>& contacts) {
    double sum = 0.0;
    for (const PadContact& contact : contacts) sum += contact.energy_nj;
    return sum;
}

// The energy of the pad where the tool is moved, and where the tumour is moved instead.
TEST(ToolBesideObstacles, TheForceOnTheToolIsOppositeToThatOnTheTumour) {
    const BodyDescription description =
        bar_beside(one_obstacle(ball_surface(Vec3(30, 3, 40), 6.0, 4)));
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    PotentialList list(body);
    Tool tool = rod_probe_at(Vec3(30.1, 3.05, 50), Vec3(4, 1, 0.05));
    tool.target_mm = Vec3(30.1, 3.05, 44);
    list.set_tool(tool);
    list.lead_tool(body.rest_positions_mm, 1.0, frame_s);
    const ToolLoad load = list.tool_load(body.rest_positions_mm);
    ASSERT_GT(load.force_un.norm(), 1.0);
    const auto energy_with = [&](const Vec3& tool_by_mm, const Vec3& tumour_by_mm) {
        Obstacle moved = description.obstacles->all[0];
        for (Vec3& x : moved.surface.vertices_mm) x += tumour_by_mm;
        std::vector<Capsule> shapes = list.tool()->shapes();
        for (Capsule& shape : shapes) shape.centre_mm += tool_by_mm;
        return energy_of(ToolObstacle(moved).contacts(*list.tool(), shapes));
    };
    for (int c = 0; c < 3; ++c) {
        const Vec3 step = 1e-5 * Vec3::Unit(c);
        const double on_tool =
                         -(energy_with(step, Vec3::Zero()) - energy_with(-step, Vec3::Zero())),
                     on_tumour =
                         -(energy_with(Vec3::Zero(), step) - energy_with(Vec3::Zero(), -step));
        EXPECT_NEAR(on_tool / 2e-5, load.force_un[c], 1e-5 * load.force_un.norm()) << c;
        EXPECT_NEAR(on_tumour / 2e-5, -load.force_un[c], 1e-5 * load.force_un.norm()) << c;
    }
}

// A hand presses no harder than it can, and jaws close no harder.
TEST(ToolBesideObstacles, ReadsNoGreaterForceThanItsLimit) {
    const BodyDescription body = bar_beside(one_obstacle(ball_surface(Vec3(30, 3, 40), 3.0)));
    for (const bool pinches : {false, true}) {
        Tool tool = pinches ? open_jaws_at(Vec3(30, 3, 40), 8.0) : probe_at(Vec3(30, 3, 50));
        for (const bool weak : {false, true}) {
            const auto stepper = make_cpu_stepper(body, {});
            if (weak) tool.force_limit_un = 100.0;
            stepper->set_tool(tool);
            if (pinches)
                stepper->open_tool(0.0);
            else
                stepper->lead_tool(Vec3(30, 3, 30));
            for (int k = 0; k < 3; ++k) stepper->step(frame_s);
            const ToolLoad& load = stepper->tool_load();
            const double felt = pinches ? load.grip_un : load.force_un.norm();
            if (weak)
                EXPECT_NEAR(felt, 100.0, 1e-6);
            else
                EXPECT_GT(felt, 1000.0);
            if (pinches) {
                EXPECT_NEAR(stepper->tool()->opening_mm, 6.4, 0.1);
            }
        }
    }
}

// What is in the liver with all of it stays there; a rod that reaches out goes through its wall.
TEST(ToolBesideObstacles, AShellHoldsWhatLiesInItAlone) {
    const BodyDescription body = bar_beside(one_obstacle(
        box_surface(Vec3(-10, -20, -20), Vec3(80, 40, 80), {4, 2, 4}), 0.2, SurfaceKind::shell));
    const TriangleMesh& wall = body.obstacles->all[0].surface;
    for (const double speed_mm_per_s : {100.0, 1e4, 1e5}) {
        const auto stepper = make_cpu_stepper(body, {});
        stepper->set_tool(probe_at(Vec3(30, 3, 80)));
        stepper->lead_tool(Vec3(30, 3, 40));  // it comes in as through a port
        stepper->step(frame_s);
        ASSERT_EQ(stepper->tool()->centre_mm(), Vec3(30, 3, 40));
        int met = 0;
        for (int k = 0; k < 60; ++k) {
            const Vec3 at = stepper->tool()->centre_mm();
            stepper->lead_tool(at + speed_mm_per_s * frame_s * Vec3(0.3 * unlike(k, 1), 0.1, 1));
            stepper->step(frame_s);
            ASSERT_GT(winding(wall, stepper->tool()->centre_mm()), 0.5) << k;
            ASSERT_LT(stepper->tool()->centre_mm().z(), 60.0 - 2.0 - 0.19) << k;
            met += stepper->tool_load().force_un.z() < 0.0 ? 1 : 0;
        }
        EXPECT_GT(met, 10);
    }
    const auto stepper = make_cpu_stepper(body, {});
    stepper->set_tool(rod_probe_at(Vec3(30, 3, 60), Vec3(0, 0, 10)));
    stepper->lead_tool(Vec3(20, 3, 65));
    stepper->step(frame_s);
    EXPECT_EQ(stepper->tool()->centre_mm(), Vec3(20, 3, 65));
    EXPECT_EQ(stepper->tool_load().force_un, Vec3(Vec3::Zero()));
}

TEST(ToolBesideObstacles, IsNotPutIntoATumour) {
    const BodyDescription body = bar_beside(one_obstacle(ball_surface(Vec3(30, 3, 40), 6.0)));
    const auto stepper = make_cpu_stepper(body, {});
    for (const double height : {40.0, 47.0})
        EXPECT_THROW(stepper->set_tool(probe_at(Vec3(30, 3, height))), InputError) << height;
    EXPECT_FALSE(stepper->tool());
    EXPECT_NO_THROW(stepper->set_tool(probe_at(Vec3(30, 3, 49))));
}

// It is met by the tool long after it has pressed the bar: the two do not know of each other.
TEST(ToolBesideObstacles, AnObstacleFarAwayChangesNoBit) {
    std::vector<Vec3> expected;
    for (const bool there : {false, true}) {
        BodyDescription body = bar();
        if (there) body.obstacles = one_obstacle(ball_surface(Vec3(30, 3, 60), 6.0));
        const auto stepper = make_cpu_stepper(body, {});
        stepper->set_tool(probe_at(Vec3(30, 3, 9)));
        for (int k = 0; k < 30; ++k) {
            stepper->lead_tool(Vec3(30, 3 + 0.02 * k, 9 - 0.1 * k));
            stepper->step(frame_s);
        }
        const auto x = stepper->positions_mm();
        if (!there) expected.assign(x.begin(), x.end());
        EXPECT_TRUE(std::ranges::equal(expected, x));
        EXPECT_GT(stepper->tool_load().contacts, 0);
    }
}

}  // namespace
}  // namespace hepatica
