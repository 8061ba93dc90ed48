// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/self_friction.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/small_matrix_eigen.h"

namespace hepatica {

Vec3 SelfFriction::Grip::slip(std::span<const Vec3> positions_mm) const {
    return small::to_eigen(slip_of(small::from_eigen(Vec3(at.between(positions_mm) - apart_mm)),
                                   small::from_eigen(normal)));
}

double SelfFriction::Grip::energy_nj(std::span<const Vec3> positions_mm) const {
    return law.energy_nj(small::from_eigen(slip(positions_mm)));
}

Vec3 SelfFriction::Grip::force_un(std::span<const Vec3> positions_mm) const {
    return small::to_eigen(law.force_un(small::from_eigen(slip(positions_mm))));
}

Mat3 SelfFriction::Grip::stiffness(std::span<const Vec3> positions_mm) const {
    return small::to_eigen(law.stiffness_un_per_mm(small::from_eigen(slip(positions_mm)),
                                                   small::from_eigen(normal), slows));
}

void SelfFriction::list_rubs(int kind, std::vector<RubPoint>& rubs) const {
    for (const Grip& grip : grips_) {
        RubPoint rub{
            {},       {},  small::from_eigen(grip.normal), small::from_eigen(grip.apart_mm),
            grip.law, kind};
        std::ranges::copy(grip.at.nodes, rub.nodes);
        std::ranges::copy(grip.at.weights, rub.weights);
        rubs.push_back(rub);
    }
}

void SelfFriction::begin_step(const BodyState& start, double dt_s,
                              std::span<const std::uint8_t> held) {
    held_ = held;
    grips_.clear();
    for (const SurfaceContact& contact : contact_.contacts(start.positions_mm))
        grips_.push_back({contact.at,
                          contact.normal,
                          contact.at.between(start.positions_mm),
                          {body_.self_pad->friction * contact.force_un, creep_mm(body_, dt_s)}});
}

double SelfFriction::energy(std::span<const Vec3> positions_mm, std::span<const Vec3>) const {
    double sum = 0.0;
    for (const Grip& grip : grips_) sum += grip.energy_nj(positions_mm);
    return sum;
}

void SelfFriction::add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3>,
                                       std::span<const int> piece_of_node,
                                       std::span<double> energy_nj) const {
    for (const Grip& grip : grips_)
        energy_nj[piece_of_node[grip.at.nodes[0]]] += grip.energy_nj(positions_mm);
}

void SelfFriction::add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const {
    for (const Grip& grip : grips_) grip.at.add_force(grip.force_un(positions_mm), forces_un);
}

// As CoulombFriction::foresee. Forces count along the slip on the first point and against it on the
// second.
void SelfFriction::foresee(std::span<const Vec3> positions_mm, std::span<const Vec3> forces_un) {
    std::unordered_map<int, double> limit_un;
    for (const Grip& grip : grips_)
        for (int a = 0; a < 4; ++a)
            limit_un[grip.at.nodes[a]] += std::abs(grip.at.weights[a]) * grip.law.limit_un;
    for (Grip& grip : grips_) {
        const Vec3 slip = grip.slip(positions_mm);
        double pressing = 0.0;
        for (int a = 0; a < 4; ++a)
            if (const double limit = limit_un[grip.at.nodes[a]]; limit > 0.0)
                pressing += grip.at.weights[a] * forces_un[grip.at.nodes[a]].dot(slip) / limit;
        grip.slows = pressing < -slowing_share * slip.norm();
    }
}

void SelfFriction::add_stiffness(std::span<const Vec3> positions_mm, double factor,
                                 BlockMatrix& matrix) const {
    for (const Grip& grip : grips_)
        add_within(grip.at, factor * grip.stiffness(positions_mm), held_, matrix);
}

void SelfFriction::add_product(std::span<const Vec3> positions_mm, double factor,
                               std::span<const Vec3> d, const BlockMatrix&,
                               std::span<Vec3> product) const {
    for (const Grip& grip : grips_)
        add_pair_product(grip.at, factor * grip.stiffness(positions_mm), true, {}, d, product);
}

void SelfFriction::add_coupling(std::span<const Vec3> positions_mm, double factor,
                                std::span<const Vec3> d, std::span<Vec3> product) const {
    for (const Grip& grip : grips_)
        add_pair_product(grip.at, factor * grip.stiffness(positions_mm), false, held_, d, product);
}

void SelfFriction::append_coupling(std::span<const Vec3> positions_mm, double factor,
                                   CouplingBlocks& blocks) const {
    for (const Grip& grip : grips_)
        append_pair_coupling(grip.at, factor * grip.stiffness(positions_mm), held_, blocks);
}

}  // namespace hepatica
