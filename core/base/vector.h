// SPDX-License-Identifier: GPL-3.0-or-later
// The vector types of the whole program. Lengths are in millimetres unless a name says otherwise.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross products
#include <array>

namespace hepatica {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Index3 = std::array<int, 3>;

}  // namespace hepatica
