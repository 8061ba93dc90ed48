// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/gravity.h"

#include "core/deform/solvers/node_loops.h"

namespace hepatica {

double Gravity::energy(std::span<const Vec3> positions_mm,
                       std::span<const Vec3> reference_mm) const {
    if (gravity_.isZero(0.0)) return 0.0;
    return -sum_over_nodes(positions_mm.size(), [&](std::size_t i) {
        return body_.mass_g[i] * gravity_.dot(positions_mm[i] - reference_mm[i]);
    });
}

void Gravity::add_energy_by_piece(std::span<const Vec3> positions_mm,
                                  std::span<const Vec3> reference_mm,
                                  std::span<const int> piece_of_node,
                                  std::span<double> energy_nj) const {
    for (std::size_t i = 0; i < positions_mm.size(); ++i)
        energy_nj[piece_of_node[i]] -=
            body_.mass_g[i] * gravity_.dot(positions_mm[i] - reference_mm[i]);
}

void Gravity::add_forces(std::span<const Vec3>, std::span<Vec3> forces_un) const {
    if (gravity_.isZero(0.0)) return;
    for_each_node(forces_un.size(),
                  [&](std::size_t i) { forces_un[i] += body_.mass_g[i] * gravity_; });
}

}  // namespace hepatica
