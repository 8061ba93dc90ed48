// SPDX-License-Identifier: GPL-3.0-or-later
// A CT of one straight bright vessel, of radius 1.8 mm, that leaves the trunk of the tree of
// test_trees.h and that the tree lacks.
#pragma once

#include <algorithm>

#include "core/image/volume.h"

namespace hepatica::test {

inline const Vec3 tube_begin_mm(1, 10, 1.5);
inline const Vec3 tube_end_mm(34, 4, 1.5);

inline Volume tube_ct() {
    Grid grid;
    grid.dims = {96, 60, 12};
    grid.spacing_mm = Vec3(0.6, 0.6, 1.5);
    grid.origin_mm = Vec3(-15, -10, -6);
    Volume ct(grid);
    const Vec3 along = tube_end_mm - tube_begin_mm;
    for (std::size_t i = 0; i < ct.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 off = grid.to_mm(x, y, z) - tube_begin_mm;
        const double share = std::clamp(off.dot(along) / along.squaredNorm(), 0.0, 1.0);
        ct.voxels[i] = (off - share * along).norm() < 1.8 ? 180 : 100;
    }
    return ct;
}

}  // namespace hepatica::test
