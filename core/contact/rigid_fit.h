// SPDX-License-Identifier: GPL-3.0-or-later
// The rotation that best fits a set of points to another, by least squares, and the largest
// deviation. After Mueller et al., A robust method to extract the rotational part of deformations,
// 2016: an iteration from an initial guess by rotations about the torque between the sets, which
// needs no eigenvectors and allows flat sets. Pure functions.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "core/base/vector.h"

namespace hepatica {

struct RigidFit {
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    double beside_mm = 0.0;  // largest distance of a point from its rotated place
};

// `shape_mm` must have mean zero; its point i is now at `positions_mm[nodes[i]]`. beside_mm holds
// for any guess; a good one is cheap. O(points).
RigidFit fit_rigid(std::span<const Vec3> shape_mm, std::span<const int> nodes,
                   std::span<const Vec3> positions_mm, const Eigen::Quaterniond& guess);

}  // namespace hepatica
