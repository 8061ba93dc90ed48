// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and tubes of voxels for the tests of this room.
#pragma once

#include <cmath>

#include "core/image/volume.h"

namespace hepatica::test {

inline Grid cubes(int size, double spacing_mm) {
    Grid grid;
    grid.dims = {size, size, size};
    grid.spacing_mm = Vec3::Constant(spacing_mm);
    return grid;
}

// Voxels from one to the other along x, both included.
inline void draw_along_x(Mask& mask, int from, int to, int y, int z) {
    for (int x = from; x <= to; ++x) mask.at(x, y, z) = 1;
}

inline void draw_along_y(Mask& mask, int x, int from, int to, int z) {
    for (int y = from; y <= to; ++y) mask.at(x, y, z) = 1;
}

// Voxels within `radius` voxels of the object.
inline Mask thickened(const Mask& lines, double radius) {
    Mask thick(lines.grid);
    const int reach = static_cast<int>(std::ceil(radius));
    const Index3& dims = lines.grid.dims;
    for (std::size_t i = 0; i < lines.voxels.size(); ++i) {
        if (!lines.voxels[i]) continue;
        const Index3 at = lines.grid.index_of(i);
        for (int dz = -reach; dz <= reach; ++dz)
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx) {
                    const int x = at[0] + dx, y = at[1] + dy, z = at[2] + dz;
                    if (dx * dx + dy * dy + dz * dz <= radius * radius && x >= 0 && y >= 0 &&
                        z >= 0 && x < dims[0] && y < dims[1] && z < dims[2])
                        thick.at(x, y, z) = 1;
                }
    }
    return thick;
}

}  // namespace hepatica::test
