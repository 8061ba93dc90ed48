// SPDX-License-Identifier: GPL-3.0-or-later
// Positions to voxels, and the comparison of grids.
#include "core/image/volume.h"

#include <algorithm>
#include <cmath>

namespace hepatica {

std::optional<Index3> voxel_at(const Grid& grid, const Vec3& position_mm) {
    if (grid.count() == 0) return std::nullopt;
    const Vec3 index = grid.to_index(position_mm);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        if (!(index[axis] >= -0.5 &&
              index[axis] <= grid.dims[static_cast<std::size_t>(axis)] - 0.5))
            return std::nullopt;
    return nearest_voxel(grid, position_mm);
}

Index3 nearest_voxel(const Grid& grid, const Vec3& position_mm) {
    const Vec3 index = grid.to_index(position_mm);
    Index3 voxel{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        voxel[axis] = static_cast<int>(std::lround(
            std::clamp(index[static_cast<Eigen::Index>(axis)], 0.0, grid.dims[axis] - 1.0)));
    return voxel;
}

bool same_grid(const Grid& a, const Grid& b) {
    if (a.dims != b.dims) return false;
    const double tolerance_mm = 0.01 * a.spacing_mm.minCoeff();
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 index((corner & 1) ? a.dims[0] - 1 : 0, (corner & 2) ? a.dims[1] - 1 : 0,
                         (corner & 4) ? a.dims[2] - 1 : 0);
        if ((a.to_mm(index) - b.to_mm(index)).norm() > tolerance_mm) return false;
    }
    return true;
}

}  // namespace hepatica
