// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/fast_marching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/error.h"

namespace hepatica {
namespace {

Grid cubes(int nx, int ny, int nz, double spacing = 1.0) {
    Grid grid;
    grid.dims = {nx, ny, nz};
    grid.spacing_mm = Vec3::Constant(spacing);
    return grid;
}

FloatVolume sampled(const Grid& grid, const std::function<double(const Vec3&)>& value) {
    FloatVolume volume(grid);
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        volume.voxels[i] = static_cast<float>(value(grid.to_mm(at[0], at[1], at[2])));
    }
    return volume;
}

// Largest error of the marched distance against the exact one, inside the object and so near to the
// middle of the grid that the nearest boundary is in it.
double worst_error(const FloatVolume& exact, MarchingOrder order, double within_mm = 1e9) {
    Job job;
    const FloatVolume marched = distance_from_level_set(exact, order, job);
    double worst = 0.0;
    const Grid& grid = exact.grid;
    const Vec3 middle = grid.to_mm(grid.dims[0] / 2, grid.dims[1] / 2, grid.dims[2] / 2);
    for (std::size_t i = 0; i < exact.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        if (exact.voxels[i] > 0.0f && (grid.to_mm(at[0], at[1], at[2]) - middle).norm() < within_mm)
            worst = std::max<double>(worst, std::abs(marched.voxels[i] - exact.voxels[i]));
    }
    return worst;
}

TEST(FastMarching, MeetsTheExactDistanceInABallAndSecondOrderMeetsItBetter) {
    const Grid grid = cubes(41, 41, 41, 0.7);
    const Vec3 centre = grid.to_mm(20, 20, 20);
    const FloatVolume exact =
        sampled(grid, [&](const Vec3& p) { return 12.3 - (p - centre).norm(); });
    const double first = worst_error(exact, MarchingOrder::first);
    const double second = worst_error(exact, MarchingOrder::second);
    EXPECT_LT(first, 0.9);
    EXPECT_LT(second, 0.3);
    EXPECT_LT(second, 0.5 * first);
}

TEST(FastMarching, MeetsTheExactDistanceInATiltedCylinder) {
    const Grid grid = cubes(40, 40, 40, 0.5);
    const Vec3 point = grid.to_mm(20, 20, 20);
    const Vec3 axis = Vec3(1, 2, 3).normalized();
    const FloatVolume exact = sampled(grid, [&](const Vec3& p) {
        const Vec3 d = p - point;
        return 6.0 - (d - d.dot(axis) * axis).norm();
    });
    EXPECT_LT(worst_error(exact, MarchingOrder::second, 7.0), 0.25);
}

TEST(FastMarching, HonoursTheSpacingOfEachAxisInASlab) {
    Grid grid = cubes(5, 5, 21);
    grid.spacing_mm = Vec3(0.6, 0.7, 2.5);
    Mask slab(grid);
    for (int z = 3; z < 18; ++z)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x) slab.at(x, y, z) = 1;
    Job job;
    for (const MarchingOrder order : {MarchingOrder::first, MarchingOrder::second}) {
        const FloatVolume distance = distance_from_boundary(slab, order, job);
        for (int z = 0; z < 21; ++z) {
            const double exact = std::max(0.0, 2.5 * (std::min(z - 2, 18 - z) - 0.5));
            EXPECT_NEAR(distance.at(2, 2, z), exact, 1e-4) << "layer " << z;
        }
    }
}

TEST(FastMarching, StaysWithinHalfAVoxelInABox) {
    const Grid grid = cubes(30, 24, 20);
    Mask box(grid);
    for (int z = 4; z < 16; ++z)
        for (int y = 4; y < 20; ++y)
            for (int x = 4; x < 26; ++x) box.at(x, y, z) = 1;
    Job job;
    const FloatVolume distance = distance_from_boundary(box, MarchingOrder::first, job);
    double worst = 0.0;
    for (int z = 4; z < 16; ++z)
        for (int y = 4; y < 20; ++y)
            for (int x = 4; x < 26; ++x) {
                const int nearest = std::min({x - 4, 25 - x, y - 4, 19 - y, z - 4, 15 - z});
                worst = std::max(worst, std::abs(distance.at(x, y, z) - (nearest + 0.5)));
            }
    EXPECT_LT(worst, 0.5);  // on the edges, which first order rounds off
}

TEST(FastMarching, ArrivesFromAPointAfterDistanceOverSpeed) {
    const Grid grid = cubes(61, 61, 1, 0.5);
    const FloatVolume speed(grid, 2.0f);
    Job job;
    const FloatVolume time =
        arrival_times(speed, {grid.offset(30, 30, 0)}, MarchingOrder::second, job);
    for (int x = 0; x < 61; ++x) EXPECT_NEAR(time.at(x, 30, 0), 0.25 * std::abs(x - 30), 1e-4);
    for (int k = 0; k < 61; ++k)
        EXPECT_NEAR(time.at(k, k, 0), 0.25 * std::sqrt(2.0) * std::abs(k - 30), 0.2);
}

TEST(FastMarching, NeverPassesAWall) {
    const Grid grid = cubes(21, 21, 1);
    FloatVolume speed(grid, 1.0f);
    for (int y = 0; y < 21; ++y) speed.at(10, y, 0) = 0.0f;
    Job job;
    const FloatVolume time =
        arrival_times(speed, {grid.offset(2, 10, 0)}, MarchingOrder::first, job);
    EXPECT_TRUE(std::isfinite(time.at(9, 0, 0)));
    for (int y = 0; y < 21; ++y) {
        EXPECT_TRUE(std::isinf(time.at(10, y, 0)));
        EXPECT_TRUE(std::isinf(time.at(15, y, 0)));
    }
}

TEST(FastMarching, FrontsInACylinderCollideOnItsAxisOnly) {
    const Grid grid = cubes(25, 25, 30);
    const Vec3 axis = grid.to_mm(12, 12, 0);
    const FloatVolume level = sampled(
        grid, [&](const Vec3& p) { return 8.2 - std::hypot(p[0] - axis[0], p[1] - axis[1]); });
    Job job;
    const Mask collisions =
        front_collisions(distance_from_level_set(level, MarchingOrder::second, job));
    for (int z = 2; z < 28; ++z)
        for (int y = 0; y < 25; ++y)
            for (int x = 0; x < 25; ++x) {
                const double from_axis = std::hypot(x - 12.0, y - 12.0);
                if (from_axis == 0.0) {
                    EXPECT_EQ(collisions.at(x, y, z), 1);
                }
                if (from_axis > 1.5) {
                    EXPECT_EQ(collisions.at(x, y, z), 0) << x << " " << y << " " << z;
                }
            }
}

TEST(FastMarching, StopsWhenCancelled) {
    const Mask all(cubes(64, 64, 64), 1);
    Job job;
    job.cancel();
    EXPECT_THROW(distance_from_boundary(all, MarchingOrder::first, job), Cancelled);
}

}  // namespace
}  // namespace hepatica
