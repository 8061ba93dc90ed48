// SPDX-License-Identifier: GPL-3.0-or-later
// Draws small sets of voxels as shaded cubes in isometric projection, without OpenGL, to show what
// an algorithm does voxel by voxel.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/vector.h"
#include "render/picture.h"

namespace hepatica {

// Voxels of one colour. A voxel in several groups takes the colour of the last.
struct VoxelGroup {
    std::vector<Index3> voxels;
    std::array<std::uint8_t, 3> colour{200, 200, 200};
};

// Draws the voxels that lie in [low, high] (inclusive) on white, with edges of `pixels` pixels. The
// picture's size depends on the box alone, so that pictures of one box have one size.
Picture draw_voxels(const std::vector<VoxelGroup>& groups, const Index3& low, const Index3& high,
                    int pixels = 18);

}  // namespace hepatica
