// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hepatica {
namespace {

Grid uneven_grid(Index3 dims) {
    Grid grid;
    grid.dims = dims;
    grid.spacing_mm = Vec3(1.0, 2.0, 4.0);
    return grid;
}

std::vector<std::size_t> neighbours_of(const Grid& grid, std::size_t voxel) {
    std::vector<std::size_t> found;
    for_each_neighbour(grid, voxel, [&](std::size_t n) { found.push_back(n); });
    return found;
}

// In a cube of 27 voxels the middle one has all others as neighbours, a corner seven of them.
TEST(Neighbours, AreAllVoxelsAroundInsideTheGrid) {
    const Grid grid = uneven_grid({3, 3, 3});
    const std::vector<std::size_t> around = neighbours_of(grid, grid.offset(1, 1, 1));
    EXPECT_EQ(around.size(), 26u);
    EXPECT_TRUE(std::ranges::is_sorted(around));
    EXPECT_EQ(std::ranges::count(around, grid.offset(1, 1, 1)), 0);
    EXPECT_EQ(neighbours_of(grid, 0), (std::vector<std::size_t>{1, 3, 4, 9, 10, 12, 13}));
}

TEST(Neighbours, AreReachedByTheStepsInTheSameOrder) {
    const Grid grid = uneven_grid({3, 3, 3});
    const auto steps = neighbour_steps(grid);
    std::vector<std::size_t> reached;
    for (const auto& [step, length_mm] : steps)
        reached.push_back(grid.offset(1 + step[0], 1 + step[1], 1 + step[2]));
    EXPECT_EQ(reached, neighbours_of(grid, grid.offset(1, 1, 1)));
    EXPECT_EQ(steps[13].step, (Index3{1, 0, 0}));
    EXPECT_EQ(steps[13].length_mm, 1.0);
    EXPECT_EQ(steps[25].length_mm, std::sqrt(21.0));
    for (std::size_t i = 0; i < 26; ++i)
        for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(steps[i].step[a], -steps[25 - i].step[a]);
}

}  // namespace
}  // namespace hepatica
