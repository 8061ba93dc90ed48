// SPDX-License-Identifier: GPL-3.0-or-later
// The fast marching method (Sethian 1996): solves |grad T| F = 1 from the boundary of an object or
// from seeds. Centreline points are where the fronts collide (section II.A.1 of the paper).
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Order of the upwind differences. First order never overshoots; second order is several times more
// accurate where the front is smooth, and falls back to first order elsewhere.
enum class MarchingOrder { first, second };

// Distance in mm from the object's boundary, inside it; 0 outside. The boundary lies half-way
// between object and background voxels; the border of the grid is not a boundary. A grid with
// dims[2] == 1 is marched in its plane. Throws Cancelled.
FloatVolume distance_from_boundary(const Mask& object, MarchingOrder order, Job& job);

// The same with sub-voxel accuracy: the object is where `level` (any unit) is > 0, and the boundary
// is the zero of its linear interpolation between voxels.
FloatVolume distance_from_level_set(const FloatVolume& level, MarchingOrder order, Job& job);

// Arrival time (mm / speed) of a front that starts at the given voxels (offsets into the grid) at
// time 0 and moves with speed[voxel] >= 0; infinity where it does not arrive. Throws Cancelled.
FloatVolume arrival_times(const FloatVolume& speed, const std::vector<std::size_t>& starts,
                          MarchingOrder order, Job& job);

// Where the fronts from opposite sides collide: object voxels (distance > 0) at which the slope of
// the distance, 1 elsewhere, is below `slope`. 1 on such voxels, 0 elsewhere. They gather on the
// medial axis but need not be connected. `distance` is the result of distance_from_boundary().
Mask front_collisions(const FloatVolume& distance, double slope = 0.7);

}  // namespace hepatica
