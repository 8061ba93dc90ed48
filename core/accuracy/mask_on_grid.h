// SPDX-License-Identifier: GPL-3.0-or-later
// Brings a mask to the grid of the truth, so that both can be compared voxel by voxel.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The object of a mask as 0 and 1 on another grid of the same frame (linear interpolation); 0 where
// the mask says nothing, because it ends there or has no voxels. Throws Cancelled.
Mask mask_on_grid(const Mask& mask, const Grid& grid, Job& job);

}  // namespace hepatica
