// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/coulomb_friction.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/deform/potentials/point_stiffness.h"

namespace hepatica {
namespace {

constexpr double creep_edges_per_s = 1e-5;
constexpr double slowing = 0.05;

}  // namespace

void CoulombFriction::begin_step(const BodyState& start, double dt_s,
                                 std::span<const std::uint8_t> held) {
    held_ = held;
    creep_mm_ = creep_edges_per_s * body_.mean_edge_mm * dt_s;
    grips_ = grips_of(start.positions_mm, dt_s);
}

Vec3 Grip::point(std::span<const Vec3> positions_mm) const {
    Vec3 point = Vec3::Zero();
    for (int a = 0; a < 3; ++a) point += weights[a] * positions_mm[nodes[a]];
    return point;
}

Vec3 CoulombFriction::slip_of(const Grip& grip, std::span<const Vec3> positions_mm) {
    const Vec3 moved = grip.point(positions_mm) - grip.anchor_mm;
    return moved - moved.dot(grip.normal) * grip.normal;
}

double CoulombFriction::energy_of(const Grip& grip, std::span<const Vec3> positions_mm) const {
    const double y = slip_of(grip, positions_mm).norm(), e = creep_mm_;
    return grip.limit_un * (y < e ? y * y / e * (1.0 - y / (3.0 * e)) : y - e / 3.0);
}

Vec3 CoulombFriction::force_of(const Grip& grip, std::span<const Vec3> positions_mm) const {
    const Vec3 slip = slip_of(grip, positions_mm);
    const double y = slip.norm(), e = creep_mm_;
    return (y < e ? -grip.limit_un / e * (2.0 - y / e) : -grip.limit_un / y) * slip;
}

Mat3 CoulombFriction::stiffness_of(const Grip& grip, std::span<const Vec3> positions_mm) const {
    const Vec3 slip = slip_of(grip, positions_mm);
    const double y = slip.norm(), e = creep_mm_;
    const Mat3 plane = Mat3::Identity() - grip.normal * grip.normal.transpose();
    if (y == 0.0) return 2.0 * grip.limit_un / e * plane;
    const Vec3 s = slip / y;
    const double across = y < e ? (2.0 - y / e) / e : 1.0 / y;
    const double along = y < e ? 2.0 * (1.0 - y / e) / e : (grip.slows ? 1.0 / y : 0.0);
    return grip.limit_un * (across * (plane - s * s.transpose()) + along * s * s.transpose());
}

// What slips is about to stick where the other forces that act on it fall short of friction by
// `slowing` of that. Both are shared out to the nodes.
void CoulombFriction::foresee(std::span<const Vec3> positions_mm, std::span<const Vec3> forces_un) {
    std::unordered_map<int, double> limit_un;
    for (const Grip& grip : grips_)
        for (int a = 0; a < 3; ++a) limit_un[grip.nodes[a]] += grip.weights[a] * grip.limit_un;
    for (Grip& grip : grips_) {
        const Vec3 slip = slip_of(grip, positions_mm);
        double pressing = 0.0;
        for (int a = 0; a < 3; ++a)
            if (const double limit = limit_un[grip.nodes[a]]; limit > 0.0)
                pressing += grip.weights[a] * forces_un[grip.nodes[a]].dot(slip) / limit;
        grip.slows = pressing < -slowing * slip.norm();
    }
}

std::vector<CoulombFriction::PointForce> CoulombFriction::point_forces(
    std::span<const Vec3> positions_mm) const {
    std::vector<PointForce> forces;
    for (const Grip& grip : grips_)
        forces.push_back({grip.point(positions_mm), force_of(grip, positions_mm)});
    return forces;
}

double CoulombFriction::energy(std::span<const Vec3> positions_mm, std::span<const Vec3>) const {
    double sum = 0.0;
    for (const Grip& grip : grips_) sum += energy_of(grip, positions_mm);
    return sum;
}

void CoulombFriction::add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3>,
                                          std::span<const int> piece_of_node,
                                          std::span<double> energy_nj) const {
    for (const Grip& grip : grips_)
        energy_nj[piece_of_node[grip.nodes[0]]] += energy_of(grip, positions_mm);
}

void CoulombFriction::add_forces(std::span<const Vec3> positions_mm,
                                 std::span<Vec3> forces_un) const {
    for (const Grip& grip : grips_) {
        const Vec3 force = force_of(grip, positions_mm);
        for (int a = 0; a < 3; ++a) forces_un[grip.nodes[a]] += grip.weights[a] * force;
    }
}

void CoulombFriction::add_stiffness(std::span<const Vec3> positions_mm, double factor,
                                    BlockMatrix& matrix) const {
    for (const Grip& grip : grips_)
        add_point_stiffness(grip.nodes, grip.weights, factor * stiffness_of(grip, positions_mm),
                            held_, matrix);
}

void CoulombFriction::add_product(std::span<const Vec3> positions_mm, double factor,
                                  std::span<const Vec3> d, const BlockMatrix&,
                                  std::span<Vec3> product) const {
    for (const Grip& grip : grips_)
        add_point_product(grip.nodes, grip.weights, factor * stiffness_of(grip, positions_mm), d,
                          product);
}

}  // namespace hepatica
