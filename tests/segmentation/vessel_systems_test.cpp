// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/vessel_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace hepatica {
namespace {

// Two tubes along x that a thin bridge joins:
//
//     ==========A==========   y = 8    (system 1 is seeded at its left end)
//               |                      bridge at x = 20
//     ==========B==========   y = 22   (system 2)
Mask two_tubes() {
    Grid grid;
    grid.dims = {40, 30, 12};
    Mask mask(grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        const auto tube = [&](int y) { return std::hypot(at[1] - y, at[2] - 6) < 3.2; };
        const bool bridge = at[0] == 20 && at[2] == 6 && at[1] > 8 && at[1] < 22;
        mask.voxels[i] = tube(8) || tube(22) || bridge;
    }
    return mask;
}

TEST(VesselSystems, TellsTwoTouchingTubesApart) {
    const Mask tubes = two_tubes();
    Job job;
    const Mask systems = label_systems(
        tubes, {{Vec3(2, 8, 6), VascularSystem::portal}, {Vec3(2, 22, 6), VascularSystem::hepatic}},
        job);
    for (int x = 0; x < 40; ++x) {
        EXPECT_EQ(systems.at(x, 8, 6), 1);
        EXPECT_EQ(systems.at(x, 22, 6), 2);
    }
    for (std::size_t i = 0; i < tubes.voxels.size(); ++i)
        EXPECT_EQ(systems.voxels[i] != 0, tubes.voxels[i] != 0);
}

TEST(VesselSystems, LeavesUnknownWhatNoSeedReaches) {
    Mask tubes = two_tubes();
    for (int y = 13; y < 17; ++y) tubes.at(20, y, 6) = 0;  // cut the bridge
    Job job;
    const Mask systems =
        label_systems(tubes, {{Vec3(2, 8, 6), VascularSystem::artery}, {Vec3(2, 22, 6)}}, job);
    EXPECT_EQ(systems.at(30, 8, 6), 3);
    EXPECT_EQ(systems.at(30, 22, 6), 255);  // its seed does not say what it is
    for (std::size_t i = 0; i < tubes.voxels.size(); ++i)
        EXPECT_EQ(systems.voxels[i] != 0, tubes.voxels[i] != 0);
}

// A line one voxel wide that goes on over edges and corners of voxels, of unequal sides.
TEST(VesselSystems, FollowsALineOfVoxelsThatOnlyTouchAtCorners) {
    Grid grid;
    grid.dims = {40, 40, 40};
    grid.spacing_mm = Vec3(0.7, 0.8, 1.5);
    Mask line(grid);
    for (int i = 2; i < 38; ++i) line.at(i, i < 20 ? i : 39 - i, i) = 1;
    Job job;
    const Mask systems = label_systems(line, {{grid.to_mm(2, 2, 2), VascularSystem::hepatic}}, job);
    EXPECT_EQ(std::count(systems.voxels.begin(), systems.voxels.end(), 2), 36);
}

// 30 steps over edges (square root of 2 each), then 30 over corners (of 3): two fronts meet
// half-way by length, not by number of steps.
TEST(VesselSystems, FrontsMeetHalfWayByTheLengthOfTheirSteps) {
    Grid grid;
    grid.dims = {64, 64, 34};
    Mask line(grid);
    const auto voxel = [](int step) {
        return Vec3(1 + step, 1 + step, 1 + std::max(0, step - 30));
    };
    for (int step = 0; step <= 60; ++step)
        line.voxels[grid.offset(1 + step, 1 + step, 1 + std::max(0, step - 30))] = 1;
    Job job;
    const Mask systems = label_systems(
        line, {{voxel(0), VascularSystem::portal}, {voxel(60), VascularSystem::hepatic}}, job);
    const double half = 0.5 * 30.0 * (std::sqrt(2.0) + std::sqrt(3.0));
    const double expected = 31.0 + std::floor((half - 30.0 * std::sqrt(2.0)) / std::sqrt(3.0));
    EXPECT_EQ(std::count(systems.voxels.begin(), systems.voxels.end(), 1), expected);
    EXPECT_EQ(std::count(systems.voxels.begin(), systems.voxels.end(), 2), 61 - expected);
}

// A tube across slices 8 mm thick: between two slices a seed lies in the lumen, 3.9 mm from the
// centre of its voxel. Beside the tube, as far from any centre, it is in none.
TEST(VesselSystems, TakesASeedAnywhereInAVoxelOfAThickSlice) {
    Grid grid;
    grid.dims = {12, 12, 6};
    grid.spacing_mm = Vec3(0.7, 0.7, 8.0);
    Mask tube(grid);
    for (int z = 0; z < 6; ++z)
        for (int y = 4; y < 8; ++y)
            for (int x = 4; x < 8; ++x) tube.at(x, y, z) = 1;
    Job job;
    const Vec3 between = grid.to_mm(5, 5, 2) + Vec3(0, 0, 3.9);
    const Mask systems = label_systems(tube, {{between, VascularSystem::hepatic}}, job);
    EXPECT_EQ(systems.at(5, 5, 2), 2);
    EXPECT_EQ(systems.at(6, 6, 5), 2);
    const Vec3 beside = grid.to_mm(2, 5, 2) + Vec3(0, 0, 3.9);
    EXPECT_THROW(require_seeds_in_vessels(tube, {{beside}}), InputError);
}

TEST(VesselSystems, RefusesASeedInNoVessel) {
    Mask tubes = two_tubes();
    Job job;
    EXPECT_THROW(label_systems(tubes, {{Vec3(20, 1, 0.0)}, {Vec3(500, 0, 0)}}, job), InputError);
}

}  // namespace
}  // namespace hepatica
