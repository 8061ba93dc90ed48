// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces whose nearness can be counted by hand.
#include "core/accuracy/surface_dice.h"

#include <gtest/gtest.h>

#include "tests/support/test_masks.h"

namespace hepatica {
namespace {

// A cube of 20 voxels' edge of 1 mm, moved along x.
Mask cube(int moved) {
    Mask mask(test::cube_grid(40));
    for (int z = 10; z < 30; ++z)
        for (int y = 10; y < 30; ++y)
            for (int x = 10; x < 30; ++x) mask.at(x + moved, y, z) = 1;
    return mask;
}

double compared(const Mask& a, const Mask& b, double tolerance_mm) {
    Job job;
    return surface_dice(a, b, Mask(a.grid, 1), tolerance_mm, job);
}

// Near at once are the rings of layers that both cubes have, or that lie within the tolerance of
// the other's first layer, 80 mm2 each; and of the end that lies inside the other the voxels within
// the tolerance of its rim.
TEST(SurfaceDice, OfAMovedCubeIsCountedByHand) {
    EXPECT_DOUBLE_EQ(compared(cube(0), cube(0), 0.0), 1.0);
    EXPECT_DOUBLE_EQ(compared(cube(0), cube(1), 0.0), (19 * 80.0 + 76.0) / 2400.0);
    EXPECT_DOUBLE_EQ(compared(cube(0), cube(1), 1.0), 1.0);
    EXPECT_DOUBLE_EQ(compared(cube(0), cube(3), 1.0), (18 * 80.0 + 76.0 + 68.0) / 2400.0);
}

TEST(SurfaceDice, WeighsFacesByTheirArea) {
    Mask bar(test::cube_grid(5));
    bar.grid.spacing_mm = Vec3(1, 2, 4);
    bar.at(2, 2, 2) = 1;
    bar.at(2, 2, 3) = 1;
    Mask half = bar;
    half.at(2, 2, 3) = 0;
    // Of the bar, the voxel that both have: 2 faces each of 2 x 4 and 1 x 4, one of 1 x 2; the
    // other as much. Of the half, all of its own 2 * (8 + 4 + 2).
    const double shared = 2 * 8 + 2 * 4 + 2, of_bar = 2 * shared, of_half = 28;
    EXPECT_DOUBLE_EQ(compared(bar, half, 1.0), (shared + of_half) / (of_bar + of_half));
}

TEST(SurfaceDice, CountsOnlyWhatIsJudged) {
    Mask judged(cube(0).grid);
    for (int z = 0; z < 40; ++z)
        for (int y = 0; y < 40; ++y)
            for (int x = 20; x < 26; ++x) judged.at(x, y, z) = 1;  // both cubes are there
    Job job;
    EXPECT_DOUBLE_EQ(surface_dice(cube(0), cube(3), judged, 0.0, job), 1.0);
    EXPECT_LT(compared(cube(0), cube(3), 0.0), 0.7);
}

TEST(SurfaceDice, OfNothingAndNothingIsOne) {
    const Mask none(test::cube_grid(8));
    EXPECT_DOUBLE_EQ(compared(none, none, 1.0), 1.0);
    EXPECT_DOUBLE_EQ(compared(cube(0), Mask(cube(0).grid), 1.0), 0.0);
}

}  // namespace
}  // namespace hepatica
