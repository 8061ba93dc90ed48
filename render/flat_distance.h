// SPDX-License-Identifier: GPL-3.0-or-later
// Distances in the plane of the picture.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace hepatica {

// From `p` to the stretch between `a` and `b`, which may be equal.
inline double distance_to_stretch(const std::array<double, 2>& p, const std::array<double, 2>& a,
                                  const std::array<double, 2>& b) {
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double square = dx * dx + dy * dy;
    const double along = (p[0] - a[0]) * dx + (p[1] - a[1]) * dy;
    const double share = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
    return std::hypot(p[0] - a[0] - share * dx, p[1] - a[1] - share * dy);
}

}  // namespace hepatica
