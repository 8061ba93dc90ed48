// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/voxel_picture.h"

#include <gtest/gtest.h>

namespace hepatica {

namespace {

std::size_t pixels_of(const Picture& picture, std::array<std::uint8_t, 3> colour) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
        count += picture.rgb[i] == colour[0] && picture.rgb[i + 1] == colour[1] &&
                 picture.rgb[i + 2] == colour[2];
    return count;
}

}  // namespace

TEST(VoxelPicture, SizeDependsOnTheBoxAlone) {
    const Picture empty = draw_voxels({}, {0, 0, 0}, {4, 4, 4});
    const Picture full =
        draw_voxels({{{{2, 2, 2}, {9, 9, 9}}, {10, 20, 200}}}, {0, 0, 0}, {4, 4, 4});
    EXPECT_EQ(empty.width, full.width);
    EXPECT_EQ(empty.height, full.height);
    EXPECT_EQ(empty.rgb.size(), 3u * empty.width * empty.height);
    EXPECT_EQ(pixels_of(empty, {255, 255, 255}), empty.rgb.size() / 3);
}

// The top face of a cube is lit in full; a cube above hides it.
TEST(VoxelPicture, NearerVoxelsHideFartherOnes) {
    const VoxelGroup blue{{{1, 1, 1}}, {10, 20, 200}};
    const std::size_t alone = pixels_of(draw_voxels({blue}, {0, 0, 0}, {3, 3, 3}), blue.colour);
    EXPECT_GT(alone, 100u);
    const VoxelGroup red{{{1, 1, 2}}, {200, 0, 0}};
    EXPECT_EQ(pixels_of(draw_voxels({blue, red}, {0, 0, 0}, {3, 3, 3}), blue.colour), 0u);
    EXPECT_EQ(pixels_of(draw_voxels({red, blue}, {0, 0, 0}, {3, 3, 3}), red.colour), alone);
}

TEST(VoxelPicture, LastGroupGivesTheColour) {
    const VoxelGroup blue{{{1, 1, 1}}, {10, 20, 200}}, red{{{1, 1, 1}}, {200, 0, 0}};
    const Picture picture = draw_voxels({blue, red}, {0, 0, 0}, {3, 3, 3});
    EXPECT_EQ(pixels_of(picture, blue.colour), 0u);
    EXPECT_GT(pixels_of(picture, red.colour), 100u);
}

}  // namespace hepatica
