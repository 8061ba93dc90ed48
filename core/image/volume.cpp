// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/volume.h"

namespace hepatica {

bool holds(const Grid& grid, const Vec3& position_mm) {
    const Vec3 index = grid.to_index(position_mm);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        if (!(index[axis] > -0.5 && index[axis] < grid.dims[static_cast<std::size_t>(axis)] - 0.5))
            return false;
    return true;
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
