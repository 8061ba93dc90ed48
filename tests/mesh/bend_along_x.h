// SPDX-License-Identifier: GPL-3.0-or-later
// Slender curved bodies, made from bricks.
#pragma once

#include <cmath>
#include <vector>

#include "core/base/vector.h"

namespace hepatica::test {

// Bends a box along x into an arc of the given angle (radians, > 0) around an axis along z beside
// it; the length of the line y = middle_y_mm is preserved.
inline void bend_along_x(std::vector<Vec3>& vertices_mm, double length_mm, double middle_y_mm,
                         double angle_rad) {
    const double radius = length_mm / angle_rad;
    for (Vec3& x : vertices_mm) {
        const double turn = angle_rad * x[0] / length_mm, r = radius - (x[1] - middle_y_mm);
        x = Vec3(r * std::sin(turn), middle_y_mm + radius - r * std::cos(turn), x[2]);
    }
}

}  // namespace hepatica::test
