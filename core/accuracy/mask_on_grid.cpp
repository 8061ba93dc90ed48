// SPDX-License-Identifier: GPL-3.0-or-later
// Resamples the mask, and clears what lies outside its own grid, where resample() repeats the
// border.
#include "core/accuracy/mask_on_grid.h"

#include "core/image/filters.h"

namespace hepatica {

Mask mask_on_grid(const Mask& mask, const Grid& grid, Job& job) {
    if (mask.voxels.empty()) return Mask(grid);
    Mask object = mask;
    for (std::uint8_t& voxel : object.voxels) voxel = voxel != 0 ? 1 : 0;
    if (same_grid(mask.grid, grid)) return object;
    Mask there = resample(object, grid, Interpolation::linear, job);
    for (std::size_t i = 0; i < there.voxels.size(); ++i) {
        if (there.voxels[i] == 0) continue;
        const auto [x, y, z] = grid.index_of(i);
        if (!holds(mask.grid, grid.to_mm(x, y, z))) there.voxels[i] = 0;
    }
    return there;
}

}  // namespace hepatica
