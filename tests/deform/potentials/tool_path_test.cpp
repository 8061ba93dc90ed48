// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tool goes that is led, turned, opened and closed past a surface that stands still,
// against closed forms.
#include "core/deform/potentials/tool_path.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/mesh/brick_mesh.h"
#include "core/mesh/surface.h"

namespace hepatica {
namespace {

using std::numbers::pi;
constexpr double keep_mm = 0.1;

// A floor at height 0 and, where wanted, nothing else near.
struct Floor {
    std::vector<Vec3> corners{Vec3(-200, -200, 0), Vec3(200, -200, 0), Vec3(0, 400, 0)};
    SurfacePatches surface{{{0, 1, 2}}};

    bool lead(Tool& tool, double share = 1.0, const ResistanceAt& resistance = {}) const {
        const ResistanceAt none = [](std::span<const Capsule>) { return ToolResistance{}; };
        return hepatica::lead(tool, {{surface, corners}}, keep_mm, share, 0.01,
                              resistance ? resistance : none);
    }
};

Tool rod(double height_mm, double half_length_mm) {
    return single_tool({.centre_mm = Vec3(1, 2, height_mm),
                        .half_axis_mm = Vec3(half_length_mm, 0, 0),
                        .radius_mm = 1.0});
}

// Two rods along x, whose surfaces are `opening_mm` apart along z, about the height of 20.
Tool jaws(double opening_mm) {
    Tool tool;
    for (const double side : {-0.5, 0.5})
        tool.parts.push_back({.shape = {.centre_mm = Vec3(0, 0, 20 + side * (opening_mm + 2.0)),
                                        .half_axis_mm = Vec3(8, 0, 0),
                                        .radius_mm = 1.0},
                              .opens = side * Vec3::UnitZ()});
    tool.opening_mm = tool.opening_target_mm = opening_mm;
    tool.target_mm = tool.centre_mm();
    return tool;
}

TEST(ToolPath, TurnsFreelyByItsAngleAndKeepsItsShape) {
    const Floor floor;
    Tool tool = rod(50, 10);
    tool.turn_rad = Vec3(0, 0, 0.75 * pi);
    EXPECT_TRUE(floor.lead(tool, 1.0 / 3.0));
    EXPECT_LT((tool.turn_rad - Vec3(0, 0, 0.5 * pi)).norm(), 1e-12);
    const Vec3 half = tool.parts[0].shape.half_axis_mm;
    EXPECT_LT((half - 10.0 * Vec3(std::cos(0.25 * pi), std::sin(0.25 * pi), 0)).norm(), 1e-12);
    // Its ends have gone that far in a hundredth of a second.
    EXPECT_NEAR(tool.speed_mm_per_s(), 100.0 * (half - Vec3(10, 0, 0)).norm(), 1e-9);
    EXPECT_TRUE(floor.lead(tool));
    EXPECT_LT(
        (tool.parts[0].shape.half_axis_mm - 10.0 * Vec3(-std::sqrt(0.5), std::sqrt(0.5), 0)).norm(),
        1e-11);
    EXPECT_EQ(tool.parts[0].shape.centre_mm, Vec3(1, 2, 50));
    floor.lead(tool);
    EXPECT_EQ(tool.turn_rad, Vec3(Vec3::Zero()));
    EXPECT_FALSE(floor.lead(tool));
}

// Its end would go down through the floor and come up again on the other side: it stops where
// height - half length sin(angle) is its radius and the gap to be kept.
TEST(ToolPath, ATurnStopsAtAFloorHoweverFarItIsToGo) {
    const Floor floor;
    for (const double angle : {0.3, 0.5 * pi, 0.99 * pi}) {
        Tool tool = rod(4.0, 15.0);
        tool.turn_rad = Vec3(0, angle, 0);
        EXPECT_TRUE(floor.lead(tool));
        const double stop = std::asin((4.0 - 1.0 - keep_mm) / 15.0);
        const Vec3 half = tool.parts[0].shape.half_axis_mm;
        EXPECT_NEAR(std::atan2(-half.z(), half.x()), stop, 0.05 * keep_mm / 15.0) << angle;
        EXPECT_NEAR(half.norm(), 15.0, 1e-11);
        EXPECT_NEAR(tool.turn_rad.y(), angle - stop, 1e-3);
        // It rests there, and can be turned back.
        floor.lead(tool);
        EXPECT_LT(tool.speed_mm_per_s(), 0.1);
        tool.turn_rad = turned_after(tool.turn_rad, Vec3(0, -angle, 0));
        EXPECT_TRUE(floor.lead(tool));
        EXPECT_NEAR(tool.parts[0].shape.half_axis_mm.z(), 0.0, 1e-3);
    }
}

// In a box, by turns of any size about any axis.
TEST(ToolPath, ATurningRodNeverLeavesAClosedBox) {
    const TetMesh box = kuhn_brick(Vec3(10, 10, 10), {2, 2, 2});
    const SurfacePatches surface(boundary_triangles(box));
    Tool tool =
        single_tool({.centre_mm = Vec3(5, 5, 5), .half_axis_mm = Vec3(3, 0, 0), .radius_mm = 0.5});
    unsigned state = 1;
    const auto in = [&](double size) {
        state = 1664525u * state + 1013904223u;
        return size * (2.0 * (state >> 8) / (1 << 24) - 1.0);
    };
    int stopped = 0;
    for (int step = 0; step < 200; ++step) {
        tool.turn_rad = Vec3(in(2), in(2), in(2));
        tool.target_mm = Vec3(5 + in(8), 5 + in(8), 5 + in(8));
        lead(tool, {{surface, box.vertices_mm}}, 0.05, 1.0, 0.01,
             [](std::span<const Capsule>) { return ToolResistance{}; });
        stopped += tool.turn_rad.norm() > 1e-6;
        for (const Vec3& end : tool.parts[0].shape.axis())
            ASSERT_TRUE((end.array() > 0.5).all() && (end.array() < 9.5).all()) << step;
    }
    EXPECT_GT(stopped, 50);
}

TEST(ToolPath, JawsCloseUntilTheyAreAboutToTouchAndOpenAgain) {
    // A slab between the heights of 18 and 21.
    std::vector<Vec3> corners = Floor{}.corners;
    for (int i = 0; i < 3; ++i) corners.push_back(corners[i] + Vec3(0, 0, 21));
    for (int i = 0; i < 3; ++i) corners[i].z() = 18;
    const SurfacePatches slab({{0, 2, 1}, {3, 4, 5}});
    const ResistanceAt none = [](std::span<const Capsule>) { return ToolResistance{}; };
    Tool tool = jaws(10.0);
    tool.opening_target_mm = 0.0;
    // The lower side is met first, and ends the motion of both.
    EXPECT_TRUE(lead(tool, {{slab, corners}}, keep_mm, 1.0, 0.01, none));
    EXPECT_NEAR(tool.opening_mm, 2.0 * (2.0 + keep_mm), 1e-6);
    EXPECT_NEAR(tool.parts[0].shape.centre_mm.z(), 18.0 - keep_mm - 1.0, 1e-6);
    EXPECT_NEAR((tool.parts[0].shape.centre_mm + tool.parts[1].shape.centre_mm).z(), 40.0, 1e-9);
    EXPECT_LT((tool.parts[1].led_by_mm - Vec3(0, 0, -0.5 * (10.0 - tool.opening_mm))).norm(), 1e-9);
    tool.opening_target_mm = 7.0;
    EXPECT_TRUE(lead(tool, {{slab, corners}}, keep_mm, 0.5, 0.01, none));
    EXPECT_NEAR(tool.opening_mm, 0.5 * (7.0 + 2.0 * (2.0 + keep_mm)), 1e-6);
}

// Springs that push back: with 100 for each millimetre that the jaws are closed, with 50 for each
// that the rod goes down.
TEST(ToolPath, StopsWhereTheBodyPushesBackWithItsLimit) {
    const Floor floor;
    Tool tool = jaws(6.0);
    tool.force_limit_un = 250.0;
    tool.opening_target_mm = 0.0;
    const auto opening = [](std::span<const Capsule> shapes) {
        return shapes[1].centre_mm.z() - shapes[0].centre_mm.z() - 2.0;
    };
    floor.lead(tool, 1.0, [&](std::span<const Capsule> shapes) {
        return ToolResistance{.grip_un = 100.0 * (6.0 - opening(shapes))};
    });
    EXPECT_NEAR(tool.opening_mm, 6.0 - 2.5, 6.0 / 4000.0);
    Tool down = rod(40, 5);
    down.force_limit_un = 250.0;
    down.target_mm.z() = 20.0;
    floor.lead(down, 1.0, [](std::span<const Capsule> shapes) {
        return ToolResistance{.force_un = Vec3(0, 0, 50.0 * (40.0 - shapes[0].centre_mm.z()))};
    });
    EXPECT_NEAR(down.centre_mm().z(), 35.0, 20.0 / 4000.0);
    // Nor does it stand where its pad would be closed, however weakly that pushes.
    Tool near = rod(40, 5);
    near.target_mm.z() = 20.0;
    floor.lead(near, 1.0, [](std::span<const Capsule> shapes) {
        return ToolResistance{.closed = shapes[0].centre_mm.z() < 33.0};
    });
    EXPECT_NEAR(near.centre_mm().z(), 33.0, 20.0 / 4000.0);
    EXPECT_GE(near.centre_mm().z(), 33.0);
    // A turn is limited by the torque of that force at its farthest end.
    Tool turned = rod(40, 5);
    turned.force_limit_un = 250.0;
    turned.turn_rad = Vec3(0, 0, 0.5);
    floor.lead(turned, 1.0, [](std::span<const Capsule> shapes) {
        const Vec3& half = shapes[0].half_axis_mm;
        return ToolResistance{.torque_un_mm = Vec3(0, 0, -6000.0 * std::atan2(half.y(), half.x()))};
    });
    const Vec3& half = turned.parts[0].shape.half_axis_mm;
    EXPECT_NEAR(std::atan2(half.y(), half.x()), 250.0 * 6.0 / 6000.0, 1e-3);
}

TEST(ToolPath, AllPartsStopWithTheFirst) {
    const Floor floor;
    Tool tool = jaws(6.0);
    tool.target_mm.z() = -20.0;
    floor.lead(tool);
    EXPECT_NEAR(tool.parts[0].shape.centre_mm.z(), 1.0 + keep_mm, 1e-5);
    EXPECT_NEAR(tool.parts[1].shape.centre_mm.z(), 1.0 + keep_mm + 8.0, 1e-5);
}

TEST(ToolPath, TurnsAfterEachOtherAreOne) {
    EXPECT_LT((turned_after(Vec3(0, 0.3, 0), Vec3(0, 0.4, 0)) - Vec3(0, 0.7, 0)).norm(), 1e-12);
    EXPECT_EQ(turned_after(Vec3::Zero(), Vec3(4, 0, 0)), Vec3(4, 0, 0));
    EXPECT_LT(turned_after(Vec3(0, 0.3, 0), Vec3(0, -0.3, 0)).norm(), 1e-12);
    const Vec3 first(0.3, -0.8, 0.5), second(1.1, 0.2, -0.4);
    const auto matrix = [](const Vec3& turn) {
        return Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    };
    const Mat3 both = matrix(second) * matrix(first);
    EXPECT_LT((matrix(turned_after(first, second)) - both).norm(), 1e-12);
}

TEST(ToolPath, WhatIsLeftOfManyTurnsIsHalfATurnAtMost) {
    for (const double angle : {90.0, 1e5, 1e11}) {
        const Vec3 left = turned_after(Vec3::Zero(), Vec3(0, 0, angle));
        EXPECT_LE(left.norm(), std::numbers::pi + 1e-12) << angle;
        EXPECT_NEAR(std::cos(left.z()), std::cos(angle), 1e-4) << angle;
    }
}

}  // namespace
}  // namespace hepatica
