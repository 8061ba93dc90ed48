// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/coulomb_friction.h"

#include <algorithm>
#include <unordered_map>

#include "core/base/parallel.h"
#include "core/base/small_matrix_eigen.h"
#include "core/deform/potentials/point_stiffness.h"

namespace hepatica {
namespace {

constexpr double creep_edges_per_s = 1e-5;

}  // namespace

double creep_mm(const Body& body, double dt_s) {
    return creep_edges_per_s * body.mean_edge_mm * dt_s;
}

void CoulombFriction::begin_step(const BodyState& start, double dt_s,
                                 std::span<const std::uint8_t> held) {
    held_ = held;
    creep_mm_ = creep_mm(body_, dt_s);
    grips_ = grips_of(start.positions_mm, dt_s);
}

Vec3 Grip::point(std::span<const Vec3> positions_mm) const {
    Vec3 point = Vec3::Zero();
    for (int a = 0; a < 3; ++a) point += weights[a] * positions_mm[nodes[a]];
    return point;
}

Vec3 CoulombFriction::slip_of(const Grip& grip, std::span<const Vec3> positions_mm) {
    return small::to_eigen(
        hepatica::slip_of(small::from_eigen(Vec3(grip.point(positions_mm) - grip.anchor_mm)),
                          small::from_eigen(grip.normal)));
}

double CoulombFriction::energy_of(const Grip& grip, std::span<const Vec3> positions_mm) const {
    return law_of(grip).energy_nj(small::from_eigen(slip_of(grip, positions_mm)));
}

Vec3 CoulombFriction::force_of(const Grip& grip, std::span<const Vec3> positions_mm) const {
    return small::to_eigen(law_of(grip).force_un(small::from_eigen(slip_of(grip, positions_mm))));
}

Mat3 CoulombFriction::stiffness_of(const Grip& grip, std::span<const Vec3> positions_mm) const {
    return small::to_eigen(
        law_of(grip).stiffness_un_per_mm(small::from_eigen(slip_of(grip, positions_mm)),
                                         small::from_eigen(grip.normal), grip.slows));
}

void CoulombFriction::list_rubs(int kind, std::vector<RubPoint>& rubs) const {
    const std::size_t before = rubs.size();
    rubs.resize(before + grips_.size());
    parallel_blocks(grips_.size(), grips_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Grip& grip = grips_[k];
            rubs[before + k] = {{grip.nodes[0], grip.nodes[1], grip.nodes[2], -1},
                                {grip.weights[0], grip.weights[1], grip.weights[2], 0.0},
                                small::from_eigen(grip.normal),
                                small::from_eigen(grip.anchor_mm),
                                law_of(grip),
                                kind};
        }
    });
}

// A slipping point is about to stick where the other forces fall short of friction by the share
// `slowing_share` of it. Limits are distributed to the nodes by the weights.
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
        grip.slows = pressing < -slowing_share * slip.norm();
    }
}

std::vector<CoulombFriction::PointForce> CoulombFriction::point_forces(
    std::span<const Vec3> positions_mm) const {
    std::vector<PointForce> forces(grips_.size());
    parallel_blocks(grips_.size(), grips_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            forces[k] = {grips_[k].point(positions_mm), force_of(grips_[k], positions_mm)};
    });
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
