// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/inscribed_radius.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/test_masks.h"

namespace hepatica {
namespace {

// By looking at every voxel, those beside the grid included.
double nearest_background_mm(const Mask& mask, const Index3& voxel) {
    double nearest = std::numeric_limits<double>::infinity();
    const Index3& dims = mask.grid.dims;
    for (int z = -1; z <= dims[2]; ++z)
        for (int y = -1; y <= dims[1]; ++y)
            for (int x = -1; x <= dims[0]; ++x) {
                if (mask.grid.contains(x, y, z) && mask.at(x, y, z) != 0) continue;
                const Vec3 way = Vec3(x - voxel[0], y - voxel[1], z - voxel[2])
                                     .cwiseProduct(mask.grid.spacing_mm);
                nearest = std::min(nearest, way.norm());
            }
    return nearest;
}

// Whatever the order of the questions, which only decides how much of the last answer serves again.
TEST(InscribedRadius, IsTheDistanceToTheNearestBackgroundLessHalfAVoxel) {
    std::mt19937_64 random(3);
    Mask mask = test::blob_mask(24, 0.5, random);
    mask.grid.spacing_mm = Vec3(0.8, 1.0, 2.5);
    InscribedRadius radius(mask);
    int asked = 0;
    for (int i = 0; i < 3000; ++i) {
        const Index3 voxel{static_cast<int>(random() % 24), static_cast<int>(random() % 24),
                           static_cast<int>(random() % 24)};
        if (mask.at(voxel[0], voxel[1], voxel[2]) == 0) continue;
        if (++asked > 300) break;
        const double expected = nearest_background_mm(mask, voxel) - 0.4;
        ASSERT_NEAR(radius.at(voxel), std::max(expected, 0.2), 1e-9);
    }
    EXPECT_GT(asked, 300);
}

TEST(InscribedRadius, IsAQuarterOfAVoxelAtLeast) {
    Mask mask(test::cube_grid(5));
    EXPECT_EQ(InscribedRadius(mask).at({2, 2, 2}), 0.25);
}

}  // namespace
}  // namespace hepatica
