// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reconstruction/mask_of_tree.h"

#include <gtest/gtest.h>

#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

//  x = 1: portal (a front came through), x = 5: unknown, the tree says hepatic, x = 9: not in the
//  tree
class MaskOfTree : public testing::Test {
  protected:
    MaskOfTree() {
        Grid grid;
        grid.dims = {12, 30, 3};
        mask_ = Mask(grid);
        for (int y = 1; y < 29; ++y) {
            mask_.at(1, y, 1) = 1;
            mask_.at(5, y, 1) = 255;
            mask_.at(9, y, 1) = 255;
        }
        VesselGraph graph;
        graph.nodes = {{Vec3(1, 2, 1), 1.0},
                       {Vec3(1, 27, 1), 1.0},
                       {Vec3(5, 2, 1), 1.0},
                       {Vec3(5, 27, 1), 1.0}};
        graph.links = {test::straight_link(graph, 0, 1, 1, 1, VascularSystem::portal),
                       test::straight_link(graph, 2, 3, 1, 1, VascularSystem::hepatic)};
        tree_ = directed(graph);
    }

    Mask mask_;
    VesselTree tree_;
};

TEST_F(MaskOfTree, WhatABridgeJoinedTakesItsSystem) {
    Job job;
    follow_tree(mask_, tree_, false, job);
    EXPECT_EQ(mask_.at(1, 20, 1), 1);
    EXPECT_EQ(mask_.at(5, 20, 1), 2);
    EXPECT_EQ(mask_.at(9, 20, 1), 255);
}

// The systems in the mask were wrong or unknown: each voxel follows the centreline in it.
TEST_F(MaskOfTree, AnewEveryVoxelFollowsItsCentreline) {
    for (std::uint8_t& voxel : mask_.voxels)
        if (voxel == 1) voxel = 3;
    Job job;
    follow_tree(mask_, tree_, true, job);
    EXPECT_EQ(mask_.at(1, 20, 1), 1);
    EXPECT_EQ(mask_.at(5, 20, 1), 2);
    EXPECT_EQ(mask_.at(9, 20, 1), 255);
}

// Points of a smooth centreline lie between slices, in the thick ones farther from the centre of
// their voxel than a seed may miss a vessel.
TEST(MaskOfTreeInThickSlices, FollowsPointsBetweenTwoSlices) {
    Grid grid;
    grid.dims = {5, 5, 6};
    grid.spacing_mm = Vec3(1, 1, 8);
    Mask mask(grid);
    for (int z = 0; z < 6; ++z) mask.at(2, 2, z) = 255;
    VesselGraph graph;
    graph.nodes = {{grid.to_mm(2, 2, 0), 1.0}, {grid.to_mm(2, 2, 5), 1.0}};
    graph.links = {test::straight_link(graph, 0, 1, 1, 1, VascularSystem::portal)};
    Job job;
    follow_tree(mask, directed(graph), true, job);
    for (int z = 0; z < 6; ++z) EXPECT_EQ(mask.at(2, 2, z), 1) << z;
}

// Also where it is no longer in the tree; one that a bridge led over tissue says nothing.
TEST_F(MaskOfTree, AnewWhatTheTreeLostIsWhatItWas) {
    Job job;
    follow_tree(mask_, tree_, true, job,
                {{Vec3(9, 4, 1), VascularSystem::portal},
                 {Vec3(7, 4, 1), VascularSystem::artery},
                 {Vec3(90, 4, 1), VascularSystem::artery}});
    EXPECT_EQ(mask_.at(9, 20, 1), 1);
    EXPECT_EQ(mask_.at(5, 20, 1), 2);
    EXPECT_EQ(mask_.at(1, 20, 1), 1);
}

}  // namespace
}  // namespace hepatica
