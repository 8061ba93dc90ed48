// SPDX-License-Identifier: GPL-3.0-or-later
// Books a finished step into the energy ledger. Let f_n be the forces at the start and f_e those
// that the step's equations have at its end (f_n - K dx for a whole linearised step, otherwise the
// forces at the end). Multiplying the equations by w gives
//   change of kinetic energy = -|w - v_n|_M^2 / 2 + f_e . dx - damping + work of the residual.
// So backward Euler loses |w - v_n|_M^2 / 2 + (f_n - f_e) . dx / 2 of the stored energy, and the
// difference between the work along the path and that of the mean of f_n and f_e is the nonlinear
// loss.
#pragma once

#include <memory>

#include "core/deform/body/body.h"
#include "core/deform/step/newton_step.h"
#include "core/deform/step/path_work.h"

namespace hepatica {

// Kinetic energy of all nodes [nJ].
double kinetic_energy(const Body& body, const std::vector<Vec3>& velocities_mm_per_s);

// Keeps references to the body and to the potential. Not thread-safe.
class StepBooks {
  public:
    StepBooks(const Body& body, IncrementalPotential& potential)
        : body_(body), potential_(potential) {}

    // The energies at the start of a step, where the potential was evaluated.
    EnergyLedger energies(const BodyState& state, const PotentialList& potentials) const;

    // Fills the report's ledger, before the velocities are limited; `audit` as in StepperOptions.
    void book(StepUnderway& step, NewtonStep& newton, bool audit, StepReport& report);

  private:
    const Body& body_;
    IncrementalPotential& potential_;
    std::unique_ptr<PathWork> path_work_;  // created by the first audit
    std::vector<Vec3> residual_;
};

}  // namespace hepatica
