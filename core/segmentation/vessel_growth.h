// SPDX-License-Identifier: GPL-3.0-or-later
// Growth of vessels from certain to likely voxels. Functions that take a job throw Cancelled.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The 26-connected pieces of `weak` that hold at least one voxel of `strong` and have a volume of
// at least minimum_mm3. Same grid for both.
Mask hysteresis(const Mask& strong, const Mask& weak, double minimum_mm3, const Job& job = Job());

// The voxels of `weak` that a path of at most reach_mm through `weak` joins to a voxel of both
// `strong` and `weak`. Every step to one of the 26 neighbours counts as one voxel. Same grid of
// cubes for both.
Mask grow_within(const Mask& strong, const Mask& weak, double reach_mm);

// The 26-connected pieces of `mask` with at least least_share (0 to 1) of their voxels in `where`.
// Labels are kept. Same grid for both.
Mask pieces_within(const Mask& mask, const Mask& where, double least_share, const Job& job = Job());

// Adds to `surface` the pieces of a skeleton outside it that join two of its parts, or are longer
// than kept_mm. All on one grid.
void rejoin(const Mask& skeleton, double kept_mm, Mask& surface, const Job& job = Job());

}  // namespace hepatica
