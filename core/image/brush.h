// SPDX-License-Identifier: GPL-3.0-or-later
// A ball that is led through a mask by hand, and leaves voxels or takes them away.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/image/volume.h"

namespace hepatica {

inline constexpr double widest_brush_mm = 50.0;  // radius, where a person may ask for any

struct BrushStroke {
    std::vector<Vec3> path_mm;  // of the ball's centre, straight from point to point; one: a dab
    double radius_mm = 1.0;     // > 0
    bool erases = false;

    bool operator==(const BrushStroke&) const = default;
};

// Calls touch(offset) for every voxel whose centre lies within the radius of the path, some of them
// more than once. The radius counts a fifth of a micrometre more, so that a grid that a file keeps
// in single precision gives the same voxels. What lies outside of the grid is left out; a ball
// between all centres takes the voxel that its own centre lies in. The work is that of the boxes
// around the path's pieces.
void sweep(const BrushStroke& stroke, const Grid& grid,
           const std::function<void(std::size_t offset)>& touch);

// To these voxels: an erasing stroke makes them 0, a painting one gives `label` to those that are 0
// and leaves the others as they are.
void apply(const BrushStroke& stroke, std::uint8_t label, Mask& mask);

}  // namespace hepatica
