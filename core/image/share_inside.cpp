// SPDX-License-Identifier: GPL-3.0-or-later
// The indicator function of a mask, smoothed and resampled.
#include "core/image/share_inside.h"

#include <algorithm>

#include "core/image/filters.h"

namespace hepatica {

FloatVolume share_inside(const Mask& part, double smoothing_mm, const Vec3& spacing_mm, Job& job) {
    FloatVolume share(part.grid);
    std::ranges::transform(part.voxels, share.voxels.begin(),
                           [](std::uint8_t voxel) { return voxel != 0 ? 1.0f : 0.0f; });
    gaussian_smooth(share, Vec3::Constant(smoothing_mm), job);
    return resample(share, respaced(share.grid, spacing_mm), Interpolation::linear, job);
}

FloatVolume with_border(const FloatVolume& inner) {
    Grid grid = inner.grid;
    for (int& count : grid.dims) count += 2;
    grid.origin_mm = inner.grid.to_mm(-1, -1, -1);
    FloatVolume padded(grid);
    paste(inner, {1, 1, 1}, padded);
    return padded;
}

}  // namespace hepatica
