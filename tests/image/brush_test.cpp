// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/brush.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/image/mask.h"

namespace hepatica {
namespace {

// Turned, and of three spacings.
Grid odd_grid() {
    Grid grid;
    grid.dims = {40, 50, 30};
    grid.spacing_mm = Vec3(0.7, 0.9, 1.3);
    grid.origin_mm = Vec3(-12, 31, 5);
    grid.direction = Eigen::AngleAxisd(0.4, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    return grid;
}

double painted_mm3(const Mask& mask) {
    const auto voxels = std::ranges::count_if(mask.voxels, [](auto v) { return v != 0; });
    return static_cast<double>(voxels) * mask.grid.spacing_mm.prod();
}

// Volumes of a ball and of a capsule, as geometry has them.
TEST(Brush, LeavesBallsAndCapsulesOfTheirVolume) {
    Mask mask(odd_grid());
    const Vec3 middle = mask.grid.to_mm(20, 25, 15);
    const double r = 6.0, ball = 4.0 / 3.0 * std::numbers::pi * r * r * r;
    apply({{middle}, r, false}, 1, mask);
    EXPECT_NEAR(painted_mm3(mask), ball, 0.02 * ball);
    Mask capsule(odd_grid());
    const Vec3 along = Vec3(3, 4, 1.5);
    apply({{middle - along, middle + along}, r, false}, 1, capsule);
    const double volume = ball + std::numbers::pi * r * r * 2.0 * along.norm();
    EXPECT_NEAR(painted_mm3(capsule), volume, 0.02 * volume);
}

// Voxel by voxel against the definition, over random strokes that reach outside, too.
TEST(Brush, TouchesWhatLiesWithinTheRadiusOfThePathAndNothingElse) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(-0.2, 1.2);
    std::uniform_real_distribution<double> radius(0.9, 5.0);
    for (int trial = 0; trial < 20; ++trial) {
        Mask mask(odd_grid(), std::uint8_t{0});
        for (std::size_t i = 0; i < mask.voxels.size(); i += 3) mask.voxels[i] = 2;
        const Mask before = mask;
        BrushStroke stroke;
        stroke.radius_mm = radius(random);
        stroke.erases = trial % 2 == 1;
        for (int p = 0; p < 1 + trial % 4; ++p)
            stroke.path_mm.push_back(
                mask.grid.to_mm(Vec3(40 * share(random), 50 * share(random), 30 * share(random))));
        apply(stroke, 9, mask);
        for (int z = 0; z < 30; ++z)
            for (int y = 0; y < 50; ++y)
                for (int x = 0; x < 40; ++x) {
                    const Vec3 place = mask.grid.to_mm(x, y, z);
                    double nearest = (place - stroke.path_mm[0]).norm();
                    for (std::size_t p = 1; p < stroke.path_mm.size(); ++p)
                        for (int k = 0; k <= 400; ++k)
                            nearest = std::min(
                                nearest, (place - stroke.path_mm[p - 1] -
                                          k / 400.0 * (stroke.path_mm[p] - stroke.path_mm[p - 1]))
                                             .norm());
                    if (std::abs(nearest - stroke.radius_mm) < 0.02) continue;  // of the samples
                    const int was = before.at(x, y, z);
                    const int expected = nearest > stroke.radius_mm ? was : stroke.erases ? 0 : 9;
                    ASSERT_EQ(mask.at(x, y, z), expected) << "trial " << trial;
                }
    }
}

TEST(GridHolds, WhatLiesInAVoxelAndNothingElse) {
    const Grid grid = odd_grid();
    const Vec3 last(39, 49, 29);
    for (int axis = 0; axis < 3; ++axis)
        for (const auto& [beside, held] : {std::pair{-0.51, false}, std::pair{-0.49, true},
                                           std::pair{0.49, true}, std::pair{0.51, false}}) {
            Vec3 index = beside < 0.0 ? Vec3(Vec3::Zero()) : last;
            index[axis] += beside;
            EXPECT_EQ(holds(grid, grid.to_mm(index)), held) << axis << ", " << beside;
        }
    EXPECT_FALSE(holds(grid, Vec3::Constant(std::nan(""))));
    EXPECT_FALSE(holds(grid, Vec3::Constant(1e300)));
    EXPECT_FALSE(holds(Grid{}, Vec3::Constant(-0.5)));
}

TEST(VoxelAt, TheFacesOfTheGridBelongToItsOutermostVoxels) {
    Grid grid{{8, 6, 4}};
    grid.spacing_mm = Vec3(1.0, 2.0, 4.0);
    grid.origin_mm = Vec3(10.0, 20.0, 40.0);
    Image<std::uint8_t> image(grid, 5);
    image.at(0, 0, 0) = 6;
    image.at(7, 5, 3) = 7;
    const Vec3 low(9.5, 19.0, 38.0), high(17.5, 31.0, 54.0);
    EXPECT_EQ(voxel_at(grid, low), (Index3{0, 0, 0}));
    EXPECT_EQ(voxel_at(grid, high), (Index3{7, 5, 3}));
    EXPECT_EQ(value_at(image, low), 6);
    EXPECT_EQ(value_at(image, high), 7);
    EXPECT_EQ(value_at(image, Vec3(high + Vec3(0.001, 0, 0))), 0);
    EXPECT_EQ(nearest_voxel(grid, Vec3(-1e300, 25.0, 1e300)), (Index3{0, 3, 3}));
}

TEST(ObjectCount, IsTheNumberOfVoxelsThatAreNotZero) {
    Mask mask(Grid{{8, 6, 4}});
    EXPECT_EQ(object_count(mask), 0u);
    mask.at(0, 0, 0) = 1;
    mask.at(7, 5, 3) = 255;
    EXPECT_EQ(object_count(mask), 2u);
    EXPECT_EQ(object_count(Mask()), 0u);
}

// Every place of a turned grid is nearest to the centre of the voxel that holds it.
TEST(VoxelAt, IsTheVoxelWhoseCentreIsNearestAlongEachAxis) {
    Image<std::uint32_t> image(odd_grid());
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
        image.voxels[i] = static_cast<std::uint32_t>(i + 1);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(-0.499, 0.499);
    for (std::size_t i = 0; i < image.voxels.size(); i += 7) {
        const auto [x, y, z] = image.grid.index_of(i);
        const Vec3 beside(share(random), share(random), share(random));
        const Vec3 place = image.grid.to_mm(Vec3(Vec3(x, y, z) + beside));
        ASSERT_EQ(value_at(image, place), i + 1);
        ASSERT_EQ(nearest_voxel(image.grid, place), (Index3{x, y, z}));
    }
}

TEST(VoxelAt, IsNowhereForWhatIsNoPlaceAndInAGridWithoutVoxels) {
    const double no_number = std::numeric_limits<double>::quiet_NaN();
    const double far = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        for (const double value : {no_number, far, -far}) {
            Vec3 place = odd_grid().to_mm(5, 5, 5);
            place[axis] = value;
            EXPECT_FALSE(holds(odd_grid(), place)) << axis << ", " << value;
        }
    const Grid flat{{4, 0, 4}};
    const Vec3 on_both_faces(0.0, -0.5, 0.0);
    EXPECT_FALSE(holds(flat, on_both_faces));
    EXPECT_EQ(value_at(Mask(flat), on_both_faces), 0);
    EXPECT_EQ(value_at(Mask(), Vec3(Vec3::Zero())), 0);
    EXPECT_EQ(value_at(Mask(odd_grid(), 1), Vec3(odd_grid().to_mm(-1, 5, 5))), 0);
}

TEST(Brush, ABallBetweenTheCentresTakesItsOwnVoxel) {
    Mask mask(odd_grid());
    apply({{mask.grid.to_mm(Vec3(10.4, 10.4, 10.4))}, 0.05, false}, 1, mask);
    EXPECT_EQ(mask.at(10, 10, 10), 1);
    EXPECT_NEAR(painted_mm3(mask), mask.grid.spacing_mm.prod(), 1e-9);
    apply({{Vec3(1e9, 0, 0), Vec3(0, 1e9, 0)}, 0.05, true}, 1, mask);
    apply({{}, 3.0, true}, 1, mask);
    EXPECT_EQ(mask.at(10, 10, 10), 1);
}

// A file keeps a grid in single precision: strokes that are led again over what was read leave the
// same, also where voxels lie just at the radius.
TEST(Brush, LeavesTheSameOnAGridThatWasReadAgain) {
    Grid grid;
    grid.dims = {41, 41, 41};
    grid.spacing_mm = Vec3(0.7, 0.7, 0.8);
    grid.origin_mm = Vec3(-14.1, 23.3, -1030.7);
    Grid read = grid;
    read.spacing_mm = grid.spacing_mm.cast<float>().cast<double>();
    read.origin_mm = grid.origin_mm.cast<float>().cast<double>();
    for (const double radius : {0.7, 2.8, 3.5, 7.0, 8.0}) {
        Mask made(grid), again(read);
        const BrushStroke dab{{grid.to_mm(20, 20, 20)}, radius, false};
        apply(dab, 1, made);
        apply(dab, 1, again);
        EXPECT_EQ(made.voxels, again.voxels) << radius;
    }
}

}  // namespace
}  // namespace hepatica
