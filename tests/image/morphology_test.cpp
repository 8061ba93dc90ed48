// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/morphology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"

namespace hepatica {
namespace {

Mask random_mask(Index3 dims, Vec3 spacing, double share, std::uint64_t seed) {
    Grid grid;
    grid.dims = dims;
    grid.spacing_mm = spacing;
    std::mt19937_64 engine(seed);
    Mask mask(grid);
    for (std::uint8_t& voxel : mask.voxels)
        voxel = static_cast<double>(engine() >> 11) * 0x1p-53 < share ? 1 : 0;
    return mask;
}

float nearest_by_search(const Mask& mask, const Index3& at, bool wanted) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        if ((mask.voxels[i] != 0) != wanted) continue;
        const Index3 other = mask.grid.index_of(i);
        const Vec3 steps(at[0] - other[0], at[1] - other[1], at[2] - other[2]);
        best = std::min(best, steps.cwiseProduct(mask.grid.spacing_mm).norm());
    }
    return static_cast<float>(best);
}

TEST(Distance, EqualsASearchOverAllVoxels) {
    Job job;
    const std::vector<Vec3> spacings{{1, 1, 1}, {0.7, 0.7, 2.5}, {3.0, 0.4, 1.1}};
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const double share = seed % 4 == 0 ? 0.005 : 0.02 * static_cast<double>(seed);
        const Mask mask = random_mask({11, 9, 8}, spacings[seed % spacings.size()], share, seed);
        const FloatVolume outside = distance_to(mask, job);
        const FloatVolume both = signed_distance(mask, job);
        for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            const Index3 at = mask.grid.index_of(i);
            const float to_object = nearest_by_search(mask, at, true);
            const bool inside = mask.voxels[i] != 0;
            const float expected = inside ? -nearest_by_search(mask, at, false) : to_object;
            if (std::isinf(to_object)) {
                EXPECT_TRUE(std::isinf(outside.voxels[i]));
                continue;
            }
            EXPECT_NEAR(outside.voxels[i], to_object, 1e-4f);
            EXPECT_NEAR(both.voxels[i], expected, 1e-4f);
        }
    }
}

TEST(Distance, IsInfiniteWithoutAnObject) {
    Job job;
    const FloatVolume distance = distance_to(random_mask({5, 4, 3}, {1, 1, 1}, 0.0, 1), job);
    for (const float d : distance.voxels) EXPECT_TRUE(std::isinf(d) && d > 0);
}

TEST(Distance, OfAPlaneIsExactOverLongAnisotropicLines) {
    Job job;
    Grid grid;
    grid.dims = {3, 3, 700};
    grid.spacing_mm = {0.5, 0.5, 1.25};
    Mask mask(grid);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) mask.at(x, y, 0) = 1;
    const FloatVolume distance = distance_to(mask, job);
    for (int z = 0; z < 700; ++z)
        EXPECT_NEAR(distance.at(1, 1, z), 1.25f * static_cast<float>(z), 2e-4f);
}

TEST(Morphology, DilatesAVoxelToTheBallAndErodesItBack) {
    Job job;
    Grid grid;
    grid.dims = {31, 31, 21};
    grid.spacing_mm = {0.5, 0.5, 1.0};
    Mask mask(grid);
    mask.at(15, 15, 10) = 1;
    const Mask ball = dilate(mask, 5.0, job);
    for (std::size_t i = 0; i < ball.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        const double r = Vec3(0.5 * (at[0] - 15), 0.5 * (at[1] - 15), at[2] - 10).norm();
        EXPECT_EQ(ball.voxels[i] != 0, r <= 5.0 + 1e-9) << r;
    }
    EXPECT_EQ(dilate(mask, 0.0, job).voxels, mask.voxels);
    const Mask centre = erode(ball, 4.9, job);
    EXPECT_EQ(centre.at(15, 15, 10), 1);
    EXPECT_LT(std::ranges::count(centre.voxels, 1), 20);
}

// Closing is extensive and idempotent, opening anti-extensive, on any mask away from the border.
TEST(Morphology, ClosingGrowsAndOpeningShrinksRandomMasks) {
    Job job;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        Mask mask = random_mask({24, 22, 20}, {1.0, 0.8, 1.5}, 0.1, seed);
        for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            const Index3 at = mask.grid.index_of(i);
            for (int a = 0; a < 3; ++a)
                if (at[a] < 5 || at[a] >= mask.grid.dims[a] - 5) mask.voxels[i] = 0;
        }
        const Mask closed = close(mask, 2.0, job);
        const Mask opened = open(mask, 1.0, job);
        for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            EXPECT_GE(closed.voxels[i], mask.voxels[i]);
            EXPECT_LE(opened.voxels[i], mask.voxels[i]);
        }
        EXPECT_EQ(close(closed, 2.0, job).voxels, closed.voxels);
    }
}

// What lies beyond the image is background: a closing knows no border.
TEST(Morphology, ClosingIsTheSameInAWiderImage) {
    Job job;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Mask mask = random_mask({14, 12, 10}, {1.0, 0.8, 1.5}, 0.05, seed);
        constexpr int more = 9;
        Grid wide = mask.grid;
        wide.origin_mm = mask.grid.to_mm(-more, -more, -more);
        for (int& n : wide.dims) n += 2 * more;
        Mask in_wide(wide);
        for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            const auto [x, y, z] = mask.grid.index_of(i);
            in_wide.at(x + more, y + more, z + more) = mask.voxels[i];
        }
        const Mask closed = close(mask, 3.0, job), closed_in_wide = close(in_wide, 3.0, job);
        EXPECT_TRUE(same_grid(closed.grid, mask.grid));
        for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            const auto [x, y, z] = mask.grid.index_of(i);
            ASSERT_EQ(closed.voxels[i], closed_in_wide.at(x + more, y + more, z + more))
                << x << " " << y << " " << z << ", seed " << seed;
        }
    }
}

// The definition: what no ball reaches whose middle is further from the object than the radius.
std::uint8_t closed_by_search(const Mask& mask, const Index3& at, double radius_mm) {
    const Vec3& spacing = mask.grid.spacing_mm;
    Index3 reach{};
    for (int a = 0; a < 3; ++a) reach[a] = static_cast<int>(radius_mm / spacing[a]) + 1;
    const auto within = [&](const Vec3& steps) {
        return steps.cwiseProduct(spacing).squaredNorm() <= radius_mm * radius_mm * (1.0 + 1e-6);
    };
    const auto is_far = [&](const Index3& middle) {
        for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
            const Index3 other = mask.grid.index_of(i);
            if (mask.voxels[i] != 0 &&
                within(Vec3(other[0] - middle[0], other[1] - middle[1], other[2] - middle[2])))
                return false;
        }
        return true;
    };
    for (int z = -reach[2]; z <= reach[2]; ++z)
        for (int y = -reach[1]; y <= reach[1]; ++y)
            for (int x = -reach[0]; x <= reach[0]; ++x)
                if (within(Vec3(x, y, z)) && is_far({at[0] + x, at[1] + y, at[2] + z})) return 0;
    return 1;
}

TEST(Morphology, ClosesAsASearchOverAllBallsDoes) {
    Job job;
    const std::vector<Vec3> spacings{{1, 1, 1}, {0.7, 0.7, 2.5}, {3.0, 0.4, 1.1}};
    for (std::uint64_t seed = 0; seed < 9; ++seed) {
        const Mask mask = random_mask({9, 7, 6}, spacings[seed % spacings.size()],
                                      0.04 + 0.02 * static_cast<double>(seed), seed);
        const double radius_mm = 1.0 + 0.4 * static_cast<double>(seed % 4);
        const Mask closed = close(mask, radius_mm, job);
        for (std::size_t i = 0; i < mask.voxels.size(); ++i)
            ASSERT_EQ(closed.voxels[i], closed_by_search(mask, mask.grid.index_of(i), radius_mm))
                << i << ", seed " << seed;
    }
}

// Boxes inside of the image and beyond its border, radii below a voxel and as wide as the image.
TEST(Morphology, ClosingInABoxIsThatPartOfTheClosing) {
    Job job;
    std::mt19937 random(5);
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const double share = std::array{0.003, 0.05, 0.4, 0.97, 0.0}[seed % 5];
        const Mask mask = random_mask({26, 21, 17}, {1.0, 0.8, 1.5}, share, seed);
        const double radius_mm = std::array{0.5, 2.0, 4.3, 30.0}[seed % 4];
        IndexBox box;
        for (int a = 0; a < 3; ++a) {
            box.begin[a] = static_cast<int>(random() % 20) - 4;
            box.end[a] = std::max(box.begin[a], 0) + 1 + static_cast<int>(random() % 12);
            box.begin[a] = std::min(box.begin[a], mask.grid.dims[a] - 1);
        }
        const Mask expected = crop(close(mask, radius_mm, job), box);
        const Mask part = close_in(mask, radius_mm, box, job);
        EXPECT_TRUE(same_grid(part.grid, expected.grid));
        ASSERT_EQ(part.voxels, expected.voxels) << "seed " << seed;
    }
    const Mask mask = random_mask({5, 5, 5}, {1, 1, 1}, 0.5, 1);
    EXPECT_THROW(close_in(mask, 1.0, {{5, 0, 0}, {7, 5, 5}}, job), InputError);
}

// A slab as near to the border as the radius, or nearer, stays the slab that it is.
TEST(Morphology, ClosingDoesNotGrowTowardsTheBorder) {
    Job job;
    for (int gap = 0; gap < 8; ++gap) {
        Grid grid;
        grid.dims = {20, 20, 20};
        Mask slab(grid);
        for (std::size_t i = 0; i < slab.voxels.size(); ++i)
            slab.voxels[i] = grid.index_of(i)[2] >= gap && grid.index_of(i)[2] < gap + 4;
        EXPECT_EQ(close(slab, 6.0, job).voxels, slab.voxels) << gap;
    }
}

std::vector<int> flood(const Mask& mask, Connectivity connectivity) {
    std::vector<int> label(mask.voxels.size(), 0);
    int next = 0;
    for (std::size_t start = 0; start < label.size(); ++start) {
        if (mask.voxels[start] == 0 || label[start] != 0) continue;
        ++next;
        std::vector<std::size_t> stack{start};
        label[start] = next;
        while (!stack.empty()) {
            const Index3 at = mask.grid.index_of(stack.back());
            stack.pop_back();
            for (int n = 0; n < 27; ++n) {
                const Index3 step{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
                const int length = std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]);
                if (length == 0 || (connectivity == Connectivity::faces6 && length > 1)) continue;
                const Index3 to{at[0] + step[0], at[1] + step[1], at[2] + step[2]};
                if (!mask.grid.contains(to[0], to[1], to[2])) continue;
                const std::size_t offset = mask.grid.offset(to[0], to[1], to[2]);
                if (mask.voxels[offset] == 0 || label[offset] != 0) continue;
                label[offset] = next;
                stack.push_back(offset);
            }
        }
    }
    return label;
}

TEST(Components, EqualAFloodFillOnRandomMasks) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const double share = 0.05 + 0.012 * static_cast<double>(seed);
        const Mask mask = random_mask({9, 8, 7}, {1, 1, 1}, share, seed);
        for (const auto connectivity : {Connectivity::faces6, Connectivity::all26}) {
            const std::vector<int> expected = flood(mask, connectivity);
            const Components found = connected_components(mask, connectivity);
            const int count = expected.empty() ? 0 : *std::ranges::max_element(expected);
            ASSERT_EQ(found.sizes.size(), static_cast<std::size_t>(count));
            EXPECT_TRUE(std::ranges::is_sorted(found.sizes, std::greater<>()));
            // A bijection between both labellings: each pair occurs with one partner only.
            std::vector<std::uint32_t> partner(static_cast<std::size_t>(count) + 1, 0);
            std::vector<std::size_t> size(found.sizes.size() + 1, 0);
            for (std::size_t i = 0; i < expected.size(); ++i) {
                const std::uint32_t label = found.labels.voxels[i];
                ASSERT_EQ(label == 0, expected[i] == 0);
                if (label == 0) continue;
                ++size[label];
                if (partner[expected[i]] == 0) partner[expected[i]] = label;
                ASSERT_EQ(partner[expected[i]], label);
            }
            for (std::size_t l = 0; l < found.sizes.size(); ++l)
                EXPECT_EQ(size[l + 1], found.sizes[l]);
        }
    }
}

TEST(Components, KeepsTheLargestOnes) {
    Grid grid;
    grid.dims = {20, 3, 3};
    Mask mask(grid);
    for (const int x : {0, 1, 2, 3, 4, 7, 8, 9, 12, 13, 16}) mask.at(x, 1, 1) = 1;
    const auto voxels = [&](int count, std::size_t minimum) {
        return std::ranges::count(
            largest_components(mask, Connectivity::all26, count, minimum).voxels, 1);
    };
    EXPECT_EQ(voxels(1, 1), 5);
    EXPECT_EQ(voxels(2, 1), 8);
    EXPECT_EQ(voxels(9, 1), 11);
    EXPECT_EQ(voxels(9, 2), 10);
    EXPECT_EQ(voxels(1, 6), 0);
}

TEST(FillHoles, FillsOnlyWhatIsShutIn) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        const Mask mask = random_mask({9, 9, 9}, {1, 1, 1}, 0.72, seed);
        Mask background(mask.grid);
        for (std::size_t i = 0; i < mask.voxels.size(); ++i)
            background.voxels[i] = mask.voxels[i] == 0 ? 1 : 0;
        const std::vector<int> rooms = flood(background, Connectivity::faces6);
        std::vector<char> open(rooms.size() + 1, 0);
        for (std::size_t i = 0; i < rooms.size(); ++i)
            for (int a = 0; a < 3; ++a) {
                const int at = mask.grid.index_of(i)[a];
                if (at == 0 || at == 8) open[rooms[i]] = 1;
            }
        const Mask filled = fill_holes(mask);
        for (std::size_t i = 0; i < rooms.size(); ++i)
            ASSERT_EQ(filled.voxels[i] != 0, mask.voxels[i] != 0 || !open[rooms[i]]);
    }
}

TEST(Morphology, GivesTheSameBytesForAnyNumberOfThreads) {
    const Mask mask = random_mask({40, 37, 31}, {0.8, 0.8, 1.5}, 0.02, 3);
    const auto bytes = [&](int threads) {
        const ThreadLimit limit(threads);
        Job job;
        return signed_distance(mask, job).voxels;
    };
    const auto one = bytes(1);
    EXPECT_EQ(one, bytes(2));
    EXPECT_EQ(one, bytes(4));
}

}  // namespace
}  // namespace hepatica
