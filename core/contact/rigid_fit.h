// SPDX-License-Identifier: GPL-3.0-or-later
// The rotation that turns a set of points best into another, by least squares, and how far the
// points are beside it. After Mueller et al., A robust method to extract the rotational part of
// deformations, 2016: from a first guess, by turns about the torque of the points on each other,
// which needs no eigenvectors and allows flat sets. Pure functions.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "core/base/vector.h"

namespace hepatica {

struct RigidFit {
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    double beside_mm = 0.0;  // of the point that is farthest from where the rotation has it
};

// `shape_mm` is about its mean; `positions_mm[nodes[i]]` is where its point i is now. The bound
// holds for every guess; a near one is cheap. O(points).
RigidFit fit_rigid(std::span<const Vec3> shape_mm, std::span<const int> nodes,
                   std::span<const Vec3> positions_mm, const Eigen::Quaterniond& guess);

}  // namespace hepatica
