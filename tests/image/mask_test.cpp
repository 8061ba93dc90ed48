// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/mask.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace hepatica {
namespace {

TEST(Masks, CountTheirObjectWhateverItsLabels) {
    Mask mask;
    mask.grid.dims = {3, 2, 1};
    mask.voxels = {0, 1, 255, 0, 3, 0};
    EXPECT_EQ(object_count(mask), 3u);
    const Mask others = complement(mask);
    EXPECT_EQ(others.grid.dims, mask.grid.dims);
    EXPECT_TRUE(std::ranges::equal(others.voxels, std::vector<int>{1, 0, 0, 1, 0, 1}));
    EXPECT_EQ(object_count(others), 3u);
    EXPECT_EQ(object_count(Mask()), 0u);
}

}  // namespace
}  // namespace hepatica
