// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/slice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace hepatica {
namespace {

constexpr std::array directions{SliceDirection::axial, SliceDirection::coronal,
                                SliceDirection::sagittal};

// What grows to the right, down and with the slices, in patient space (LPS).
const std::array<Mat3, 3> screen{
    (Mat3() << 1, 0, 0, 0, 1, 0, 0, 0, 1).finished(),
    (Mat3() << 1, 0, 0, 0, 0, 1, 0, -1, 0).finished(),
    (Mat3() << 0, 0, 1, 1, 0, 0, 0, -1, 0).finished(),
};

// Every way in which a scanner may store the axes of a patient: 6 orders, 8 sets of signs.
std::vector<Grid> stored_ways() {
    std::vector<Grid> grids;
    std::array<int, 3> order{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Grid grid;
            grid.dims = {5, 7, 9};
            grid.spacing_mm = Vec3(0.7, 0.8, 1.5);
            grid.origin_mm = Vec3(-12, 30, 4);
            grid.direction.setZero();
            for (int i = 0; i < 3; ++i)
                grid.direction(order[static_cast<std::size_t>(i)], i) = (signs >> i & 1) ? -1 : 1;
            grids.push_back(grid);
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return grids;
}

TEST(Slice, LiesAsARadiologistLooksHoweverTheVoxelsAreStored) {
    for (const Grid& grid : stored_ways())
        for (std::size_t d = 0; d < 3; ++d) {
            const SliceStack stack(grid, directions[d]);
            const Vec3 steps(stack.column_mm(), stack.row_mm(), stack.slice_mm());
            for (int i = 0; i < 3; ++i) {
                const Vec3 along = stack.to_mm(Vec3::Unit(i)) - stack.to_mm(Vec3::Zero());
                EXPECT_LT((along - steps[i] * screen[d].col(i)).norm(), 1e-12);
            }
        }
}

TEST(Slice, OfAnObliqueGridTakesItsNearestAxes) {
    Grid grid;
    grid.dims = {4, 5, 6};
    grid.direction = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (std::size_t d = 0; d < 3; ++d) {
        const SliceStack stack(grid, directions[d]);
        for (int i = 0; i < 3; ++i) {
            const Vec3 along = stack.to_mm(Vec3::Unit(i)) - stack.to_mm(Vec3::Zero());
            EXPECT_GT(along.dot(screen[d].col(i)), std::cos(0.4) - 1e-12);
        }
    }
}

TEST(Slice, PlacesAreThoseOfItsVoxels) {
    std::mt19937 chance(5);
    for (const Grid& grid : stored_ways())
        for (const SliceDirection direction : directions) {
            const SliceStack stack(grid, direction);
            const auto draw = [&](int n) {
                return std::uniform_int_distribution(0, n - 1)(chance);
            };
            const int column = draw(stack.columns()), row = draw(stack.rows()),
                      slice = draw(stack.count());
            const Index3 voxel = stack.voxel(column, row, slice);
            ASSERT_TRUE(grid.contains(voxel[0], voxel[1], voxel[2]));
            const Vec3 place(column, row, slice);
            EXPECT_LT((stack.to_mm(place) - grid.to_mm(voxel[0], voxel[1], voxel[2])).norm(), 1e-9);
            EXPECT_LT((stack.place_of(stack.to_mm(place)) - place).norm(), 1e-9);
        }
}

TEST(Slice, EdgesAreNamedByWhereTheyLookTo) {
    const Grid grid;
    EXPECT_EQ(SliceStack(grid, SliceDirection::axial).edges(), (std::array{'R', 'L', 'A', 'P'}));
    EXPECT_EQ(SliceStack(grid, SliceDirection::coronal).edges(), (std::array{'R', 'L', 'H', 'F'}));
    EXPECT_EQ(SliceStack(grid, SliceDirection::sagittal).edges(), (std::array{'A', 'P', 'H', 'F'}));
}

TEST(Slice, GreyRunsFromBlackToWhiteOverTheWindow) {
    Volume ct(Grid{{6, 2, 1}});
    ct.voxels = {-2000, 0, 50, 100, 200, 3000, 25, 75, 150, 99, 101, 1};
    const SliceStack stack(ct.grid, SliceDirection::axial);
    const auto grey = grey_slice(ct, stack, 0, {100.0, 200.0});
    for (std::size_t i = 0; i < grey.size(); ++i) {
        const double expected = std::clamp(255.0 * ct.voxels[i] / 200.0, 0.0, 255.0);
        EXPECT_NEAR(grey[i], expected, 0.5);
    }
}

// Each pixel asks for its own place, on grids along the picture's axes, swapped ones and oblique
// ones.
TEST(Slice, LabelsComeFromTheirOwnGrid) {
    Grid ct;
    ct.dims = {20, 21, 22};
    Mat3 swapped;
    swapped << 0, 0, 1, -1, 0, 0, 0, 1, 0;
    const Mat3 oblique = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (const Mat3& direction_of_labels : {Mat3(Mat3::Identity()), swapped, oblique}) {
        Mask labels(Grid{{3, 4, 5}, Vec3(2, 2, 2), Vec3(4.5, 6.5, 2.5), direction_of_labels});
        for (std::size_t i = 0; i < labels.voxels.size(); ++i)
            labels.voxels[i] = static_cast<std::uint8_t>(i + 1);
        for (const SliceDirection direction : directions) {
            const SliceStack stack(ct, direction);
            int labelled = 0;
            for (int slice = 0; slice < stack.count(); ++slice) {
                const auto found = label_slice(labels, stack, slice);
                for (int row = 0; row < stack.rows(); ++row)
                    for (int column = 0; column < stack.columns(); ++column) {
                        const Vec3 index =
                            labels.grid.to_index(stack.to_mm(Vec3(column, row, slice)));
                        const Vec3 nearest = (index.array() + 0.5).floor();
                        const int x = static_cast<int>(nearest.x()),
                                  y = static_cast<int>(nearest.y()),
                                  z = static_cast<int>(nearest.z());
                        const int expected = labels.grid.contains(x, y, z) ? labels.at(x, y, z) : 0;
                        labelled += expected > 0;
                        EXPECT_EQ(found[static_cast<std::size_t>(stack.columns() * row + column)],
                                  expected);
                    }
            }
            EXPECT_GT(labelled, 100);
        }
    }
}

}  // namespace
}  // namespace hepatica
