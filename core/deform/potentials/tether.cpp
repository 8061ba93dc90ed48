// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/tether.h"

#include <algorithm>

#include "core/deform/solvers/node_loops.h"

namespace hepatica {

Tether::Tether(const Body& body)
    : body_(body),
      any_(std::ranges::any_of(body.tether_un_per_mm, [](double k) { return k > 0.0; })) {}

double Tether::energy_of(std::size_t i, const Vec3& position_mm) const {
    return 0.5 * body_.tether_un_per_mm[i] *
           (position_mm - body_.rest_positions_mm[i]).squaredNorm();
}

double Tether::energy(std::span<const Vec3> positions_mm, std::span<const Vec3>) const {
    if (!any_) return 0.0;
    return sum_over_nodes(positions_mm.size(),
                          [&](std::size_t i) { return energy_of(i, positions_mm[i]); });
}

void Tether::add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3>,
                                 std::span<const int> piece_of_node,
                                 std::span<double> energy_nj) const {
    for (std::size_t i = 0; any_ && i < positions_mm.size(); ++i)
        energy_nj[piece_of_node[i]] += energy_of(i, positions_mm[i]);
}

void Tether::add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const {
    if (!any_) return;
    for_each_node(positions_mm.size(), [&](std::size_t i) {
        forces_un[i] += body_.tether_un_per_mm[i] * (body_.rest_positions_mm[i] - positions_mm[i]);
    });
}

void Tether::add_stiffness(std::span<const Vec3> positions_mm, double factor,
                           BlockMatrix& matrix) const {
    if (!any_) return;
    for_each_node(positions_mm.size(), [&](std::size_t i) {
        matrix.block[matrix.diagonal[i]].diagonal().array() += factor * body_.tether_un_per_mm[i];
    });
}

void Tether::add_product(std::span<const Vec3>, double factor, std::span<const Vec3> d,
                         const BlockMatrix&, std::span<Vec3> product) const {
    if (!any_) return;
    for_each_node(d.size(), [&](std::size_t i) {
        product[i] += (factor * body_.tether_un_per_mm[i]) * d[i];
    });
}

void Tether::mark_held(std::span<const Vec3>, std::span<char> held) const {
    for (std::size_t i = 0; any_ && i < held.size(); ++i)
        if (body_.tether_un_per_mm[i] > 0.0) held[i] = 1;
}

}  // namespace hepatica
