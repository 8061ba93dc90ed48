// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/territories/feeders.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tree/territories/textbook_portal.h"

namespace hepatica {
namespace {

VesselSegment straight(const Vec3& from, const Vec3& to, int node, VascularSystem system) {
    VesselSegment segment;
    segment.proximal_node = node;
    segment.distal_node = node + 1;
    segment.system = system;
    segment.points_mm = {from, to};
    segment.radii_mm = {1.0, 1.0};
    return segment;
}

// Two parallel vessels and a ball across the plane half-way between them. Oracle: the part of a
// ball of radius r beyond a plane at distance d is (2 - 3 d/r + (d/r)^3) / 4 (Archimedes).
TEST(Feeders, ShareABallByThePlaneHalfWay) {
    Grid grid;
    grid.dims = {61, 41, 41};
    const Mask liver(grid, 1);
    VesselTree tree;
    tree.segments = {straight(Vec3(5, 20, 0), Vec3(5, 20, 40), 0, VascularSystem::portal),
                     straight(Vec3(55, 20, 0), Vec3(55, 20, 40), 2, VascularSystem::portal),
                     straight(Vec3(30, 2, 20), Vec3(50, 2, 20), 4, VascularSystem::artery),
                     straight(Vec3(29, 20, 0), Vec3(29, 20, 40), 6, VascularSystem::hepatic)};
    for (const VesselSegment& segment : tree.segments) {
        tree.nodes.push_back({segment.points_mm.front(), 1.0});
        tree.nodes.push_back({segment.points_mm.back(), 1.0});
    }
    constexpr double radius = 12.0, offset = 6.0;  // the middle of the way is x = 30
    Mask tumours(grid);
    for (std::size_t i = 0; i < tumours.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        if ((Vec3(x, y, z) - Vec3(30 - offset, 20, 20)).norm() <= radius) tumours.voxels[i] = 10;
    }
    tumours.at(57, 20, 20) = 11;
    Job job;
    const auto feeders = feeders_of(tree, liver, tumours, {10, 11}, job);
    ASSERT_EQ(feeders.size(), 2u);
    ASSERT_EQ(feeders[0].size(), 3u);
    const double ratio = offset / radius;
    const double beyond = (2.0 - 3.0 * ratio + std::pow(ratio, 3.0)) / 4.0;
    EXPECT_EQ(feeders[0][0].segment, 0);
    EXPECT_NEAR(feeders[0][0].share, 1.0 - beyond, 0.03);
    EXPECT_EQ(feeders[0][1].segment, 1);
    EXPECT_NEAR(feeders[0][1].share, beyond, 0.03);
    EXPECT_NEAR(feeders[0][0].share + feeders[0][1].share, 1.0, 1e-12);
    EXPECT_EQ(feeders[0][2].segment, 2);
    EXPECT_EQ(feeders[0][2].system, VascularSystem::artery);
    EXPECT_EQ(feeders[0][2].share, 1.0);
    ASSERT_EQ(feeders[1].size(), 2u);
    EXPECT_EQ(feeders[1][0].segment, 1);
    EXPECT_EQ(feeders[1][0].share, 1.0);
}

// A tumour about a branch that was drawn for segment 6 is fed by branches of segment 6.
TEST(Feeders, OfATumourInASegmentAreItsBranches) {
    const auto patient =
        test::textbook_patient(test::PortalType::usual, true, test::liver_of_phantom(3.0));
    const Grid& grid = patient.liver.grid;
    Mask tumours(grid);
    const Vec3 index = grid.to_index(Vec3(-108, 36, -44));
    tumours.at(static_cast<int>(std::lround(index.x())), static_cast<int>(std::lround(index.y())),
               static_cast<int>(std::lround(index.z()))) = 10;
    Job job;
    const auto feeders = feeders_of(patient.tree, patient.liver, tumours, {10, 12}, job);
    ASSERT_EQ(feeders[0].size(), 1u);
    EXPECT_EQ(patient.segment[feeders[0][0].segment], 6);
    EXPECT_TRUE(feeders[1].empty());  // there is no tumour 12
}

}  // namespace
}  // namespace hepatica
