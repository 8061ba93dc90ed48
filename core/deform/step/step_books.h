// SPDX-License-Identifier: GPL-3.0-or-later
// Books a finished step into the energy ledger. With f_n the forces at the start and f_e those that
// the step's equations have at its end (f_n - K dx of a whole linearised step, else the forces at
// the end), the equations multiplied by w say
//   change of kinetic energy = -|w - v_n|_M^2 / 2 + f_e . dx - damping + work of the residual,
// so that, of what is stored, backward Euler loses (f_n - f_e) . dx / 2 beside |w - v_n|_M^2 / 2,
// and what the mean of f_n and f_e misses of the work on the way is the nonlinear loss.
#pragma once

#include <memory>

#include "core/deform/body/body.h"
#include "core/deform/step/newton_step.h"
#include "core/deform/step/path_work.h"

namespace hepatica {

// Of all nodes [nJ].
double kinetic_energy(const Body& body, const std::vector<Vec3>& velocities_mm_per_s);

// Keeps references to the body and to the potential. Not thread-safe.
class StepBooks {
  public:
    StepBooks(const Body& body, IncrementalPotential& potential)
        : body_(body), potential_(potential) {}

    // The energies of the state that a step starts from, at which the potential was evaluated.
    EnergyLedger energies(const BodyState& state, const PotentialList& potentials) const;

    // Fills the report's ledger, before any limit of the velocities; `audit` as in StepperOptions.
    void book(StepUnderway& step, NewtonStep& newton, bool audit, StepReport& report);

  private:
    const Body& body_;
    IncrementalPotential& potential_;
    std::unique_ptr<PathWork> path_work_;  // made with the first audit
    std::vector<Vec3> residual_;
};

}  // namespace hepatica
