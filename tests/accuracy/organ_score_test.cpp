// SPDX-License-Identifier: GPL-3.0-or-later
// Oracle: cubes that overlap by a known number of voxels, and balls of known radii.
#include "core/accuracy/organ_score.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/base/error.h"
#include "tests/support/test_masks.h"

namespace hepatica {
namespace {

Mask cube(int from, int to, const Grid& grid) {
    return test::mask_where(grid, [=](const Vec3& p) {
        return p.minCoeff() >= from && p.maxCoeff() < to && p.x() >= from;
    });
}

TEST(OrganScore, CountsVoxels) {
    const Grid grid = test::cube_grid(24);
    const Mask truth = cube(4, 14, grid);  // 1000 voxels
    const Mask found = cube(6, 14, grid);  // 512 of them
    Job job;
    const OrganScore small = organ_score(found, truth, job);
    EXPECT_NEAR(small.dice, 1024.0 / 1512.0, 1e-12);
    EXPECT_NEAR(small.outside_share, 0.0, 1e-12);
    EXPECT_NEAR(small.missed_share, 0.488, 1e-12);
    const OrganScore large = organ_score(truth, found, job);
    EXPECT_NEAR(large.dice, small.dice, 1e-12);
    EXPECT_NEAR(large.outside_share, 0.488, 1e-12);
    EXPECT_NEAR(large.missed_share, 0.0, 1e-12);
    EXPECT_NEAR(large.surface_mean_mm, small.surface_mean_mm, 1e-9);
}

TEST(OrganScore, MeasuresHowFarTheSurfacesAre) {
    Grid grid = test::cube_grid(50);
    grid.spacing_mm = Vec3::Constant(2.0);
    const auto ball = [&](double radius_mm) {
        return test::mask_where(
            grid, [=](const Vec3& p) { return (p - Vec3(49, 49, 49)).norm() < radius_mm; });
    };
    Job job;
    EXPECT_NEAR(organ_score(ball(36), ball(28), job).surface_mean_mm, 8.0, 0.5);
    EXPECT_EQ(organ_score(ball(36), ball(36), job).surface_mean_mm, 0.0);
    const OrganScore nothing = organ_score(Mask(grid), Mask(grid), job);
    EXPECT_EQ(nothing.dice, 1.0);
    EXPECT_EQ(nothing.surface_mean_mm, 0.0);
    const OrganScore missed = organ_score(Mask(grid), ball(20), job);
    EXPECT_EQ(missed.dice, 0.0);
    EXPECT_EQ(missed.missed_share, 1.0);
    job.cancel();
    EXPECT_THROW(organ_score(ball(20), ball(22), job), Cancelled);
}

// What the image cuts off is no surface: two slabs through the whole image, 3 mm apart in front.
TEST(OrganScore, TakesTheImagesBorderForNoSurface) {
    const Grid grid = test::cube_grid(20);
    const auto slab = [&](double to) {
        return test::mask_where(grid, [=](const Vec3& p) { return p.x() < to; });
    };
    Job job;
    EXPECT_NEAR(organ_score(slab(10), slab(13), job).surface_mean_mm, 3.0, 1e-6);
}

TEST(OrganScore, MeasuresNoDistanceWhereAMaskFillsTheImage) {
    const Grid grid = test::cube_grid(12);
    const Mask full(grid, 1), part = cube(3, 8, grid);
    Job job;
    for (const auto& [found, truth] : {std::pair{full, full}, {full, part}, {part, full}})
        EXPECT_EQ(organ_score(found, truth, job).surface_mean_mm, 0.0);
    EXPECT_EQ(organ_score(full, full, job).dice, 1.0);
    EXPECT_LT(organ_score(full, part, job).dice, 0.2);
}

}  // namespace
}  // namespace hepatica
