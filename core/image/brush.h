// SPDX-License-Identifier: GPL-3.0-or-later
// A spherical brush that paints or erases voxels of a mask along a path drawn by hand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/image/volume.h"

namespace hepatica {

inline constexpr double widest_brush_mm = 50.0;  // largest radius that a user may choose

struct BrushStroke {
    std::vector<Vec3> path_mm;  // of the ball's centre, straight lines between points
    double radius_mm = 1.0;     // > 0
    bool erases = false;

    bool operator==(const BrushStroke&) const = default;
};

// Calls touch(offset) for every voxel whose centre lies within the radius of the path, and for the
// voxel that contains a point of the path; some of them more than once. The radius is enlarged by a
// fifth of a micrometre, so that a grid stored in single precision gives the same voxels. Voxels
// outside the grid are left out. Cost: the voxels in the bounding boxes of the path's pieces.
void sweep(const BrushStroke& stroke, const Grid& grid,
           const std::function<void(std::size_t offset)>& touch);

// Applies a stroke to the voxels of sweep(): an erasing stroke sets them to 0, a painting one to
// `label`, whatever they were.
void apply(const BrushStroke& stroke, std::uint8_t label, Mask& mask);

}  // namespace hepatica
