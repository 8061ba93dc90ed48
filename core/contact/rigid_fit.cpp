// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/rigid_fit.h"

#include <algorithm>
#include <cmath>

namespace hepatica {
namespace {

constexpr int most_turns = 8;
constexpr double small_turn_rad = 1e-4;

}  // namespace

RigidFit fit_rigid(std::span<const Vec3> shape_mm, std::span<const int> nodes,
                   std::span<const Vec3> positions_mm, const Eigen::Quaterniond& guess) {
    Vec3 centre = Vec3::Zero();
    Mat3 moments = Mat3::Zero();  // the centre drops out, because the shape has mean zero
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Vec3& x = positions_mm[nodes[i]];
        centre += x;
        moments += x * shape_mm[i].transpose();
    }
    centre /= static_cast<double>(nodes.size());
    RigidFit fit{.turn = guess};
    for (int k = 0; k < most_turns; ++k) {
        const Mat3 turned = fit.turn.toRotationMatrix();
        Vec3 torque = Vec3::Zero();
        double along = 0.0;
        for (int c = 0; c < 3; ++c) {
            torque += turned.col(c).cross(moments.col(c));
            along += turned.col(c).dot(moments.col(c));
        }
        const double size = torque.norm();
        if (!(size > small_turn_rad * std::abs(along))) break;
        const double angle = std::min(size / std::abs(along), 1.0);
        fit.turn = (Eigen::Quaterniond(Eigen::AngleAxisd(angle, torque / size)) * fit.turn);
        fit.turn.normalize();
    }
    const Mat3 turned = fit.turn.toRotationMatrix();
    double squared = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        squared = std::max(squared,
                           (positions_mm[nodes[i]] - centre - turned * shape_mm[i]).squaredNorm());
    fit.beside_mm = std::sqrt(squared);
    return fit;
}

}  // namespace hepatica
