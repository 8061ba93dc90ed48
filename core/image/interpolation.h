// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolation between voxels.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/image/volume.h"

namespace hepatica {

// Trilinear interpolation at a position in mm; outside the grid the border values are repeated. The
// image must not be empty.
template <class T>
double interpolate(const Image<T>& image, const Vec3& position_mm) {
    const Vec3 index = image.grid.to_index(position_mm);
    int low[3], high[3];
    double share[3];
    for (int a = 0; a < 3; ++a) {
        const int last = image.grid.dims[a] - 1;
        const double at = std::clamp(index[a], 0.0, static_cast<double>(last));
        low[a] = std::min(static_cast<int>(at), last);
        high[a] = std::min(low[a] + 1, last);
        share[a] = at - low[a];
    }
    const auto along_x = [&](int y, int z) {
        const double left = image.at(low[0], y, z);
        return left + share[0] * (image.at(high[0], y, z) - left);
    };
    const auto in_plane = [&](int z) {
        const double near = along_x(low[1], z);
        return near + share[1] * (along_x(high[1], z) - near);
    };
    const double below = in_plane(low[2]);
    return below + share[2] * (in_plane(high[2]) - below);
}

}  // namespace hepatica
