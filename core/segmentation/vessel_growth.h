// SPDX-License-Identifier: GPL-3.0-or-later
// Growth of vessels from where they are certain to where they are likely. Those that are given a
// job throw Cancelled.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The 26-connected pieces of `weak` that hold at least one voxel of `strong` and at least
// minimum_mm3 of volume. Same grid for both.
Mask hysteresis(const Mask& strong, const Mask& weak, double minimum_mm3, const Job& job = Job());

// What of `weak` can be reached from `strong` by a path of at most reach_mm through `weak`, in
// steps to 26 neighbours counted as one voxel each. Same grid of cubes for both.
Mask grow_within(const Mask& strong, const Mask& weak, double reach_mm);

// The 26-connected pieces of `mask` of whose voxels at least least_share lie in `where`. Same grid
// for both.
Mask pieces_within(const Mask& mask, const Mask& where, double least_share, const Job& job = Job());

// Puts back the pieces of a skeleton outside a surface that join two of its parts, or are longer
// than kept_mm. All on one grid.
void rejoin(const Mask& skeleton, double kept_mm, Mask& surface, const Job& job = Job());

}  // namespace hepatica
