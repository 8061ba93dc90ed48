// SPDX-License-Identifier: GPL-3.0-or-later
// The arms of a fork: where each is measured, of long and of short vessels and from either end.
#include "core/tree/systems/vessel_pieces.h"

#include <gtest/gtest.h>

#include <vector>

namespace hepatica {
namespace {

// A fork at the origin: one long straight vessel, and the one that is given by its points and
// radii, from the fork on.
VesselGraph fork_with(const std::vector<Vec3>& points_mm, const std::vector<double>& radii_mm) {
    VesselGraph graph;
    graph.nodes = {{Vec3::Zero(), 0.5}, {Vec3(-20, 0, 0), 0.5}, {points_mm.back(), 0.5}};
    VesselLink straight{0, 1, VascularSystem::unknown, 0.0, {}, {}};
    for (int i = 0; i <= 20; ++i) {
        straight.points_mm.push_back(Vec3(-i, 0, 0));
        straight.radii_mm.push_back(0.5);
    }
    graph.links = {straight, {0, 2, VascularSystem::unknown, 0.0, points_mm, radii_mm}};
    return graph;
}

// The arm of the second link, which is the same from whichever end the link is stored.
ForkArm second_arm(VesselGraph graph) {
    std::vector<ForkArm> arms;
    for (int turned = 0; turned < 2; ++turned) {
        const PieceGraph pieces = pieces_of(graph, nullptr);
        EXPECT_EQ(pieces.forks.size(), 1u);
        if (pieces.forks.size() != 1 || pieces.forks[0].size() != 2) return {};
        arms.push_back(pieces.forks[0][1]);
        EXPECT_EQ(arms.back().node, 0);
        reverse(graph.links[1]);
    }
    EXPECT_EQ(arms[0].direction, arms[1].direction);
    EXPECT_EQ(arms[0].position_mm, arms[1].position_mm);
    EXPECT_EQ(arms[0].radius_mm, arms[1].radius_mm);
    return arms[0];
}

// Beyond the lumen, over five millimetres: 1 to 6 mm along a vessel that turns after 7.
TEST(ForkArms, AreMeasuredOverFiveMillimetresBeyondTheLumen) {
    std::vector<Vec3> points;
    std::vector<double> radii;
    for (int i = 0; i <= 7; ++i) {
        points.push_back(Vec3(i, 0, 0));
        radii.push_back(1.0 + 0.1 * i);
    }
    for (int i = 1; i <= 7; ++i) {
        points.push_back(Vec3(7, i, 0));
        radii.push_back(0.2);
    }
    const ForkArm arm = second_arm(fork_with(points, radii));
    EXPECT_EQ(arm.position_mm, Vec3(1, 0, 0));
    EXPECT_EQ(arm.direction, Vec3(1, 0, 0));
    EXPECT_NEAR(arm.radius_mm, 1.4, 1e-12);  // the upper median of 1.1 to 1.6
}

// A vessel that is shorter than that is measured up to its last point, and not beyond.
TEST(ForkArms, OfAShortVesselReachToItsEnd) {
    const ForkArm arm = second_arm(
        fork_with({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(3, 1, 0)},
                  {0.5, 0.5, 0.6, 0.7, 0.8}));
    EXPECT_EQ(arm.position_mm, Vec3(1, 0, 0));
    EXPECT_NEAR((arm.direction - Vec3(2, 1, 0).normalized()).norm(), 0.0, 1e-12);
    EXPECT_EQ(arm.radius_mm, 0.7);  // of all but the first
}

// Of two points it has a direction, too.
TEST(ForkArms, OfTwoPointsBeginInTheFork) {
    const ForkArm arm = second_arm(fork_with({Vec3(0, 0, 0), Vec3(0, 3, 0)}, {0.5, 0.7}));
    EXPECT_EQ(arm.position_mm, Vec3(0, 0, 0));
    EXPECT_EQ(arm.direction, Vec3(0, 1, 0));
    EXPECT_EQ(arm.radius_mm, 0.7);
}

}  // namespace
}  // namespace hepatica
