// SPDX-License-Identifier: GPL-3.0-or-later
// The energy ledger of a step, and over several. What a body has gained must equal what was put in
// less what was lost:
//   change of (kinetic + elastic + grab + tether + contact + cohesion) = gravity_work + tool_work -
//   damping_loss - friction_loss - integrator_loss - nonlinear_loss - limiter_loss -
//   tear_loss - inversion_recovery_loss + solver_work + imbalance.
// Of these nonlinear_loss alone depends on whether forces are the gradients of the energies. In an
// audited step (StepperOptions::audit) it is computed from forces alone, and a force that is not
// shows up as imbalance. Otherwise it is taken from the energies, and the imbalance says that the
// step obeys its equations and that no term is forgotten, but nothing about the forces.
#pragma once

namespace hepatica {

// Energies in nanojoule (g mm2/s2) at the end of the step; the other terms over the step.
struct EnergyLedger {
    double kinetic = 0.0;
    double elastic = 0.0;
    double grab = 0.0;             // stored in grab springs
    double tether = 0.0;           // stored in the springs of the surrounding tissue
    double contact = 0.0;          // stored in the pads of tools and between surfaces
    double cohesion = 0.0;         // stored in what still binds parted joints
    double gravity_work = 0.0;     // done on the body during the step
    double tool_work = 0.0;        // done by moving targets during the step
    double damping_loss = 0.0;     // >= 0
    double friction_loss = 0.0;    // >= 0
    double integrator_loss = 0.0;  // of backward Euler in a body of constant stiffness:
                                   // (|change of velocity|_M^2 + |motion|_K^2) / 2, >= 0
    double nonlinear_loss = 0.0;   // of forces that change otherwise along the step than its
                                   // equations have them: their work on the straight way from start
                                   // to end less that of the mean of start and end; of third order
                                   // in the step where the stiffness is exact, of either sign
    double limiter_loss = 0.0;     // taken from the velocities: the step would have made energy
    double tear_loss = 0.0;  // fracture: what the ties of parted joints have given up for good
    double inversion_recovery_loss = 0.0;  // given up where elements inside out were put right
    double solver_work = 0.0;              // done by the forces that the linear solver left
                                           // unbalanced, and by E of eq. (11) where it is used
    double imbalance = 0.0;                // what does not add up; 0 but for rounding
};

// kinetic + elastic + grab + tether + contact + cohesion [nJ].
double stored_energy(const EnergyLedger& ledger);
// gravity_work + tool_work [nJ].
double work_put_in(const EnergyLedger& ledger);
// The change of stored_energy that the terms of the ledger explain: all but the imbalance [nJ].
double explained_change(const EnergyLedger& ledger);

// The second step after the first: energies of the end, works and losses summed.
EnergyLedger in_sequence(const EnergyLedger& first, const EnergyLedger& second);

// Sum of the sizes of all terms but the imbalance [nJ].
double energy_handled(const EnergyLedger& ledger);
// |imbalance| over that; 0 where all are 0.
double relative_imbalance(const EnergyLedger& ledger);

}  // namespace hepatica
