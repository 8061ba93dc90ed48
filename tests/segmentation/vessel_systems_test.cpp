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
    const Mask systems = label_systems(tubes, {{Vec3(2, 8, 6), 1}, {Vec3(2, 22, 6), 2}}, job);
    for (int x = 0; x < 40; ++x) {
        EXPECT_EQ(systems.at(x, 8, 6), 1);
        EXPECT_EQ(systems.at(x, 22, 6), 2);
    }
    for (std::size_t i = 0; i < tubes.voxels.size(); ++i)
        EXPECT_EQ(systems.voxels[i] != 0, tubes.voxels[i] != 0);
}

TEST(VesselSystems, DropsWhatNoSeedReaches) {
    Mask tubes = two_tubes();
    for (int y = 13; y < 17; ++y) tubes.at(20, y, 6) = 0;  // cut the bridge
    Job job;
    const Mask systems = label_systems(tubes, {{Vec3(2, 8, 6), 3}}, job);
    EXPECT_EQ(systems.at(30, 8, 6), 3);
    EXPECT_EQ(systems.at(30, 22, 6), 0);
}

TEST(VesselSystems, GivesAPieceOfAnOverlapBackInOneStep) {
    Job job;
    const std::vector<VesselSeed> seeds{{Vec3(2, 8, 6), 1}};
    Mask systems = label_systems(two_tubes(), seeds, job);  // 1 has taken both tubes
    ASSERT_EQ(systems.at(30, 22, 6), 1);
    const std::size_t changed = reassign_overlap(systems, seeds, {Vec3(20, 22, 6), 2}, job);
    EXPECT_EQ(changed, static_cast<std::size_t>(
                           std::count(systems.voxels.begin(), systems.voxels.end(), 2)));
    for (int x = 0; x < 40; ++x) {
        EXPECT_EQ(systems.at(x, 22, 6), 2);
        EXPECT_EQ(systems.at(x, 8, 6), 1);
    }
    EXPECT_EQ(reassign_overlap(systems, seeds, {Vec3(20, 22, 6), 2}, job), 0u);
}

TEST(VesselSystems, RefusesASeedInNoVessel) {
    Mask tubes = two_tubes();
    Job job;
    EXPECT_THROW(label_systems(tubes, {{Vec3(20, 1, 0.0), 1}, {Vec3(500, 0, 0), 2}}, job),
                 InputError);
    EXPECT_THROW(label_systems(tubes, {{Vec3(2, 8, 6), 0}}, job), InputError);
    EXPECT_THROW(reassign_overlap(tubes, {}, {Vec3(-50, 8, 6), 2}, job), InputError);
}

}  // namespace
}  // namespace hepatica
