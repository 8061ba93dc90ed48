// SPDX-License-Identifier: GPL-3.0-or-later
// Resamples the mask where it lies on another grid.
#include "core/accuracy/mask_on_grid.h"

#include "core/image/filters.h"

namespace hepatica {

Mask mask_on_grid(const Mask& mask, const Grid& grid, Job& job) {
    if (mask.voxels.empty()) return Mask(grid);
    Mask object = mask;
    for (std::uint8_t& voxel : object.voxels) voxel = voxel != 0 ? 1 : 0;
    if (same_grid(mask.grid, grid)) return object;
    return resample_within(object, grid, job);
}

}  // namespace hepatica
