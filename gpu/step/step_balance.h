// SPDX-License-Identifier: GPL-3.0-or-later
// The data of a step on a machine while it is made, eq. (12): its energies by pieces of the body,
// and intermediate results.
#pragma once

#include <vector>

#include "core/deform/body/body_state.h"
#include "core/deform/body/energy_ledger.h"
#include "core/deform/step/energy_limiter.h"
#include "gpu/kernels/step_kernels.h"

namespace hepatica::gpu {

// Energies of the whole body and of its pieces.
struct Balance {
    std::vector<double> of_pieces;  // Energies::width numbers each

    double sum(int term) const {
        double total = 0.0;
        for (std::size_t k = term; k < of_pieces.size(); k += Energies::width)
            total += of_pieces[k];
        return total;
    }
    // Energy of elements and potentials.
    double potential() const {
        return sum(Energies::elastic) + sum(Energies::grab) + sum(Energies::tether) +
               sum(Energies::weight) + sum(Energies::contact) + sum(Energies::friction) +
               sum(Energies::cohesion);
    }
    EnergyLedger ledger() const {
        EnergyLedger ledger;
        ledger.kinetic = sum(Energies::kinetic);
        ledger.elastic = sum(Energies::elastic);
        ledger.grab = sum(Energies::grab);
        ledger.tether = sum(Energies::tether);
        ledger.contact = sum(Energies::contact);
        ledger.friction_loss = sum(Energies::friction);
        ledger.cohesion = sum(Energies::cohesion);
        ledger.gravity_work = -sum(Energies::weight);
        return ledger;
    }
    std::vector<EnergyLimiter::Balance> by_piece() const {
        std::vector<EnergyLimiter::Balance> pieces;
        for (std::size_t p = 0; p < of_pieces.size(); p += Energies::width) {
            const double* e = &of_pieces[p];
            pieces.push_back({e[Energies::kinetic] + e[Energies::elastic] + e[Energies::grab] +
                                  e[Energies::tether] + e[Energies::weight] + e[Energies::contact] +
                                  e[Energies::friction] + e[Energies::cohesion],
                              e[Energies::kinetic]});
        }
        return pieces;
    }
};

// Strains below this are rounding; at rest all energies are.
constexpr double strain_rounding = 1e-12;

// Energies below this [nJ] are rounding: about the energy of the body at that strain.
inline double energy_of_rounding(const Body& body) {
    double sum = 0.0;
    for (const ElementGroup& group : body.groups) {
        for (const auto& rest : group.tetrahedra) sum += rest.mu * rest.volume;
        for (const auto& rest : group.springs)
            for (int e = 0; e < 6; ++e)
                sum += 0.5 * rest.stiffness[e] * rest.length[e] * rest.length[e];
    }
    return strain_rounding * strain_rounding * sum;
}

// One step while it is made; energies in nJ.
struct Underway {
    double dt_s = 0.0;
    BodyState start{};                     // only where the body may touch something
    std::vector<Vec3> from_mm{}, to_mm{};  // the same: where the iterate begins and ends
    bool predicted = false;                // it begins at w = v_n; otherwise at w = 0
    Balance before{};
    double standing = 0.0;   // incremental potential at w = 0
    double value = 0.0;      // the same where the iterate begins
    double slope = 0.0;      // its slope along the direction taken
    double curvature = 0.0;  // see LinearisedWork; set where the iterate begins at w = 0
    double residual_work = 0.0;
    double damping_form = 0.0;  // w . beta K_0 w at the end
    Balance after{};
};

}  // namespace hepatica::gpu
