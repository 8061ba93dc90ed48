// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/rigid_motion.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>

namespace hepatica {
namespace {

constexpr double most_turn = 1.0;  // radians per step

// I^-1 L; zero about an axis without inertia.
Vec3 spin_of(const Mat3& inertia, const Vec3& angular_momentum) {
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(inertia);
    Vec3 spin = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const double moment = axes.eigenvalues()[k];
        if (!(moment > 1e-12 * axes.eigenvalues()[2])) continue;
        const Vec3 axis = axes.eigenvectors().col(k);
        spin += axis.dot(angular_momentum) / moment * axis;
    }
    return spin;
}

}  // namespace

RigidMotion rigid_motion(std::span<const int> nodes, std::span<const double> mass,
                         std::span<const Vec3> x, std::span<const Vec3> v) {
    double total = 0.0;
    Vec3 centre = Vec3::Zero(), momentum = Vec3::Zero(), angular = Vec3::Zero();
    const Vec3 origin = x[nodes[0]];  // no digits are lost far from the origin
    for (const int i : nodes) {
        total += mass[i];
        centre += mass[i] * (x[i] - origin);
        momentum += mass[i] * v[i];
    }
    RigidMotion motion;
    motion.centre_mm = origin + centre / total;
    motion.velocity_mm_per_s = momentum / total;
    Mat3 inertia = Mat3::Zero();
    for (const int i : nodes) {
        const Vec3 r = x[i] - motion.centre_mm;
        angular += mass[i] * r.cross(Vec3(v[i] - motion.velocity_mm_per_s));
        inertia += mass[i] * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
    }
    motion.spin_per_s = spin_of(inertia, angular);
    motion.spin_energy_nj = 0.5 * motion.spin_per_s.dot(inertia * motion.spin_per_s);
    motion.flight_energy_nj = 0.5 * total * motion.velocity_mm_per_s.squaredNorm();
    return motion;
}

std::vector<Vec3> straight_ways(const RigidMotion& motion, std::span<const int> nodes,
                                std::span<const Vec3> x, double dt) {
    const double rate = motion.spin_per_s.norm();
    const Vec3 axis = rate > 0.0 ? Vec3(motion.spin_per_s / rate) : Vec3::UnitX();
    const Mat3 turn = Eigen::AngleAxisd(std::min(rate * dt, most_turn), axis).toRotationMatrix();
    std::vector<Vec3> ways;
    ways.reserve(nodes.size());
    for (const int i : nodes) {
        const Vec3 r = x[i] - motion.centre_mm;
        ways.push_back(motion.velocity_mm_per_s + (turn * r - r) / dt);
    }
    return ways;
}

std::optional<std::vector<Vec3>> common_velocity(std::span<const double> mass_g,
                                                 std::span<const std::uint8_t> held,
                                                 std::span<const Vec3> velocities) {
    Vec3 momentum = Vec3::Zero();
    double mass = 0.0;
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        if (held[i] != 0) return std::nullopt;
        momentum += mass_g[i] * velocities[i];
        mass += mass_g[i];
    }
    return std::vector<Vec3>(velocities.size(), Vec3(momentum / mass));
}

}  // namespace hepatica
