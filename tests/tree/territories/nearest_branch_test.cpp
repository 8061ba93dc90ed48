// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/territories/nearest_branch.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "tests/support/checks_until.h"

namespace hepatica {
namespace {

Grid cube(int edge, double spacing_mm) {
    Grid grid;
    grid.dims = {edge, edge, edge};
    grid.spacing_mm = Vec3::Constant(spacing_mm);
    return grid;
}

// Straight vessels, each a tree of its own, in this order.
VesselTree vessels(const std::vector<std::array<Vec3, 2>>& ends) {
    VesselTree tree;
    for (const auto& [from, to] : ends) {
        VesselSegment segment;
        segment.proximal_node = static_cast<int>(tree.nodes.size());
        segment.distal_node = segment.proximal_node + 1;
        segment.points_mm = {from, to};
        segment.radii_mm = {1.0, 1.0};
        tree.nodes.push_back({from, 1.0});
        tree.nodes.push_back({to, 1.0});
        tree.segments.push_back(segment);
    }
    return tree;
}

double distance_mm(const VesselTree& tree, int segment, const Vec3& at) {
    VesselTree one;
    one.segments = {tree.segments[segment]};
    return nearest_point(one, at).distance_mm;
}

// Oracle: straight distances to all of them. Steps along a lattice make paths longer by at most 8
// %.
TEST(NearestBranch, IsTheNearestInAConvexOrgan) {
    const Mask organ(cube(40, 1.0), 1);
    const VesselTree tree = vessels({{Vec3(5, 5, 5), Vec3(30, 8, 6)},
                                     {Vec3(8, 33, 10), Vec3(20, 20, 30)},
                                     {Vec3(35, 35, 35), Vec3(34, 12, 30)}});
    const std::vector<std::int32_t> owners{0, 1, 2};
    Job job;
    const auto nearest = nearest_branch(organ, tree, owners, job);
    for (std::size_t i = 0; i < nearest.voxels.size(); ++i) {
        const auto [x, y, z] = organ.grid.index_of(i);
        const Vec3 at = organ.grid.to_mm(x, y, z);
        ASSERT_NE(nearest.voxels[i], no_owner);
        double least = std::numeric_limits<double>::infinity();
        for (int s = 0; s < 3; ++s) least = std::min(least, distance_mm(tree, s, at));
        EXPECT_LE(distance_mm(tree, nearest.voxels[i], at), 1.128 * least + 1.0) << at.transpose();
    }
}

// A wall with a door far away: what is nearer through the wall is farther on foot.
TEST(NearestBranch, GoesRoundAFissure) {
    Mask organ(cube(30, 1.0), 1);
    for (int y = 0; y < 25; ++y)
        for (int z = 0; z < 30; ++z) organ.at(15, y, z) = 0;
    const VesselTree tree =
        vessels({{Vec3(13, 2, 2), Vec3(13, 2, 28)}, {Vec3(28, 2, 2), Vec3(28, 2, 28)}});
    const std::vector<std::int32_t> owners{3, 7};
    Job job;
    const auto nearest = nearest_branch(organ, tree, owners, job);
    EXPECT_EQ(nearest.at(14, 2, 15), 3);
    EXPECT_EQ(nearest.at(16, 2, 15), 7);  // 3 mm from the first as the crow flies, 12 from this
    EXPECT_EQ(nearest.at(15, 2, 15), no_owner);
    EXPECT_EQ(nearest.at(16, 29, 15), 3);  // beyond the door the first is nearer
}

// The organ leaves out a vessel's lumen, which leads from its centreline to both sides. Within one
// layer of voxels there is no way round.
TEST(NearestBranch, LeadsThroughTheLumenInASingleLayer) {
    for (std::size_t flat = 0; flat < 3; ++flat) {
        const std::size_t along = (flat + 1) % 3, across = (flat + 2) % 3;
        Grid grid = cube(30, 1.0);
        grid.dims[flat] = 1;
        Mask organ(grid, 1);
        for (std::size_t i = 0; i < organ.voxels.size(); ++i)
            if (std::abs(grid.index_of(i)[across] - 12) <= 2) organ.voxels[i] = 0;
        const auto place = [&](double a, double b) {
            Vec3 at = Vec3::Zero();
            at[static_cast<Eigen::Index>(along)] = a;
            at[static_cast<Eigen::Index>(across)] = b;
            return at;
        };
        VesselTree tree = vessels({{place(2, 12), place(27, 12)}, {place(2, 26), place(27, 26)}});
        tree.segments[0].radii_mm = {3.0, 3.0};
        Job job;
        const auto nearest = nearest_branch(organ, tree, std::vector<std::int32_t>{3, 7}, job);
        const auto owner_at = [&](double b) {
            const Vec3 at = place(15, b);
            return nearest.at(static_cast<int>(at.x()), static_cast<int>(at.y()),
                              static_cast<int>(at.z()));
        };
        EXPECT_EQ(owner_at(12), no_owner);
        EXPECT_EQ(owner_at(16), 3) << "4 mm from the one, 10 from the other; flat " << flat;
        EXPECT_EQ(owner_at(8), 3);
        EXPECT_EQ(owner_at(22), 7);
    }
}

TEST(NearestBranch, ReachesIslandsInAStraightLine) {
    Mask organ(cube(30, 1.0));
    for (int x = 0; x < 10; ++x) organ.at(x, 5, 5) = 1;
    organ.at(28, 5, 5) = 1;
    organ.at(12, 25, 5) = 1;
    const VesselTree tree =
        vessels({{Vec3(1, 5, 5), Vec3(8, 5, 5)}, {Vec3(25, 20, 20), Vec3(28, 5, 20)}});
    const std::vector<std::int32_t> owners{0, 1};
    Job job;
    const auto nearest = nearest_branch(organ, tree, owners, job);
    EXPECT_EQ(nearest.at(5, 5, 5), 0);
    EXPECT_EQ(nearest.at(28, 5, 5), 1);
    EXPECT_EQ(nearest.at(12, 25, 5), 0);  // 20 mm from the first, 20.6 from the second
}

TEST(NearestBranch, WhatOwnsNothingIsPassedOver) {
    const Mask organ(cube(20, 1.0), 1);
    const VesselTree tree =
        vessels({{Vec3(2, 2, 2), Vec3(2, 2, 18)}, {Vec3(18, 18, 2), Vec3(18, 18, 18)}});
    Job job;
    const auto second = nearest_branch(organ, tree, std::vector<std::int32_t>{no_owner, 4}, job);
    for (const std::int32_t owner : second.voxels) EXPECT_EQ(owner, 4);
    const auto none =
        nearest_branch(organ, tree, std::vector<std::int32_t>{no_owner, no_owner}, job);
    for (const std::int32_t owner : none.voxels) EXPECT_EQ(owner, no_owner);
}

TEST(NearestBranch, StopsWhenItIsCancelled) {
    const Mask organ(cube(20, 1.0), 1);
    const VesselTree tree = vessels({{Vec3(2, 2, 2), Vec3(2, 2, 18)}});
    Job job;
    job.cancel();
    EXPECT_THROW(nearest_branch(organ, tree, std::vector<std::int32_t>{0}, job), Cancelled);
}

// As a tree in another program's space: no front starts, and every voxel looks for the nearest
// branch in a straight line.
TEST(NearestBranch, StopsWhereTheTreeLiesFarFromTheOrgan) {
    const Mask organ(cube(20, 1.0), 1);
    const VesselTree tree = vessels({{Vec3(-500, 0, 0), Vec3(-500, 0, 9)}});
    const auto checks_until = [&](int last) {
        return test::checks_until(last, [&](Job& job) {
            nearest_branch(organ, tree, std::vector<std::int32_t>{0}, job);
        });
    };
    const int whole = checks_until(-1);
    EXPECT_GE(whole, 8000 / 256);  // voxels between two looks
    EXPECT_EQ(checks_until(whole), -whole);
}

}  // namespace
}  // namespace hepatica
