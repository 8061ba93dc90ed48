// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/skeleton/unit_width_skeleton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/skeleton/thinning.h"
#include "core/skeleton/topology.h"
#include "tests/support/test_masks.h"

namespace hepatica {

using namespace test;

namespace {

Mask thinned(const Mask& mask) {
    Job job;
    return thin(mask, ThinningMethod::queue, job);
}

Mask unit_width_of(const Mask& skeleton) {
    Job job;
    return unit_width(skeleton, job);
}

}  // namespace

// The method must keep the topology of whatever it is given, not only of skeletons.
TEST(UnitWidthSkeleton, KeepsTheTopologyAndLeavesNothingRemovable) {
    for (int trial = 0; trial < 3000; ++trial) {
        std::mt19937_64 random(trial);
        const Mask mask = bernoulli_mask(7, 0.05 + 0.5 * uniform(random), random);
        const Mask thinner = unit_width_of(mask);
        ASSERT_EQ(betti_numbers(thinner), betti_numbers(mask)) << "seed " << trial;
        ASSERT_EQ(removable_point_count(thinner), 0u) << "seed " << trial;
    }
}

TEST(UnitWidthSkeleton, KeepsTheTopologyOfThinnedBlobs) {
    for (int trial = 0; trial < 150; ++trial) {
        std::mt19937_64 random(trial);
        const Mask mask = blob_mask(24, 0.1 + 0.4 * uniform(random), random);
        const Mask thinner = unit_width_of(thinned(mask));
        ASSERT_EQ(betti_numbers(thinner), betti_numbers(mask)) << "seed " << trial;
        ASSERT_EQ(removable_point_count(thinner), 0u) << "seed " << trial;
    }
}

//   . . . #          a plus sign with a crowded 3 x 3 middle:
//   # # # # # # #    the middle's own centre is the median, the four arms are the exits
TEST(UnitWidthSkeleton, StagesOfACrossWithAThickMiddle) {
    Mask mask(cube_grid(11));
    for (int i = 0; i < 11; ++i) mask.at(i, 5, 5) = mask.at(5, i, 5) = 1;
    for (int y = 4; y <= 6; ++y)
        for (int x = 4; x <= 6; ++x) mask.at(x, y, 5) = 1;
    Job job;
    const UnitWidthStages stages = unit_width_stages(mask, job);
    ASSERT_EQ(stages.regions.size(), 1u);
    const CrowdedRegion& region = stages.regions[0];
    EXPECT_EQ(region.centre, mask.grid.offset(5, 5, 5));
    EXPECT_EQ(region.exits.size(), 4u);
    for (const auto& path : region.paths) {
        ASSERT_FALSE(path.empty());
        EXPECT_EQ(path.front(), region.centre);
    }
    EXPECT_EQ(stages.skeleton.at(4, 4, 5), 0);
    EXPECT_EQ(stages.skeleton.at(6, 4, 5), 0);
    EXPECT_EQ(removable_point_count(stages.skeleton), 0u);
    EXPECT_EQ(betti_numbers(stages.skeleton), betti_numbers(mask));
    EXPECT_EQ(stages.skeleton.at(0, 5, 5), 1);
    EXPECT_EQ(stages.skeleton.at(5, 10, 5), 1);
}

// Sum of the squared distances to the region's voxels over the degree, as it is defined.
double valence_score(const Mask& mask, const CrowdedRegion& region, std::size_t voxel) {
    const Index3 p = mask.grid.index_of(voxel);
    double distances = 0.0;
    for (const std::size_t other : region.voxels) {
        const Index3 q = mask.grid.index_of(other);
        for (std::size_t a = 0; a < 3; ++a) distances += (p[a] - q[a]) * (p[a] - q[a]);
    }
    int degree = -1;  // the voxel itself is counted below
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const int x = p[0] + dx, y = p[1] + dy, z = p[2] + dz;
                degree += mask.grid.contains(x, y, z) && mask.at(x, y, z) != 0;
            }
    return distances / degree;
}

TEST(UnitWidthSkeleton, TheCentreIsTheSpatialMedianOfItsRegion) {
    int judged = 0;
    for (int trial = 0; trial < 40; ++trial) {
        std::mt19937_64 random(trial);
        const Mask mask = thinned(blob_mask(24, 0.1 + 0.4 * uniform(random), random));
        Job job;
        for (const CrowdedRegion& region : unit_width_stages(mask, job).regions) {
            double best = std::numeric_limits<double>::infinity();
            for (const std::size_t voxel : region.voxels)
                best = std::min(best, valence_score(mask, region, voxel));
            EXPECT_DOUBLE_EQ(valence_score(mask, region, region.centre), best) << trial;
            judged += region.voxels.size() > 3;
        }
    }
    EXPECT_GT(judged, 50);
}

// A ring of crowded points around a hole: removing all but a star of paths would close the tunnel.
TEST(UnitWidthSkeleton, TunnelInsideACrowdedRegionStaysOpen) {
    Mask mask(cube_grid(13));
    for (int y = 3; y <= 9; ++y)
        for (int x = 3; x <= 9; ++x) {
            const int r = std::max(std::abs(x - 6), std::abs(y - 6));
            if (r >= 2 && r <= 3) mask.at(x, y, 6) = 1;
        }
    for (int i = 0; i < 3; ++i) mask.at(i, 6, 6) = mask.at(12 - i, 6, 6) = 1;
    ASSERT_EQ(betti_numbers(mask), (Betti{1, 1, 0}));
    EXPECT_EQ(betti_numbers(unit_width_of(mask)), (Betti{1, 1, 0}));
}

// A comb: one crowded region, and each tooth an exit to which a path is searched.
TEST(UnitWidthSkeleton, AsksBeforeEachPathOfARegion) {
    constexpr int teeth = 20;
    Grid grid;
    grid.dims = {4 * teeth, 8, 3};
    Mask comb(grid);
    for (int x = 0; x < grid.dims[0]; ++x) comb.at(x, 0, 1) = comb.at(x, 1, 1) = 1;
    for (int tooth = 0; tooth < teeth; ++tooth)
        for (int y = 2; y < 6; ++y) comb.at(4 * tooth + 1, y, 1) = 1;
    Job job;
    int asked = 0;
    job.observe([&](JobEvent) { ++asked; });
    const UnitWidthStages stages = unit_width_stages(comb, job);
    ASSERT_EQ(stages.regions.size(), 1u);
    EXPECT_EQ(stages.regions[0].exits.size(), static_cast<std::size_t>(teeth));
    EXPECT_GE(asked, teeth);
}

TEST(UnitWidthSkeleton, LineIsLeftAlone) {
    Mask mask(cube_grid(9));
    for (int i = 0; i < 9; ++i) mask.at(i, i, i) = 1;
    EXPECT_EQ(unit_width_of(mask).voxels, mask.voxels);
    EXPECT_EQ(crowded_point_count(mask), 0u);
}

TEST(UnitWidthSkeleton, NothingBecomesNothing) {
    EXPECT_EQ(count_object(unit_width_of(Mask(cube_grid(3)))), 0u);
}

}  // namespace hepatica
