// SPDX-License-Identifier: GPL-3.0-or-later
// The energy ledger of one step or of several. What a body gains must equal what was put in less
// what was lost:
//   change of (kinetic + elastic + grab + tether + contact + cohesion) = gravity_work + tool_work -
//   damping_loss - friction_loss - integrator_loss - nonlinear_loss - limiter_loss -
//   tear_loss - inversion_recovery_loss + solver_work + imbalance.
// Of these terms only nonlinear_loss depends on whether the forces are the gradients of the
// energies. In an audited step (StepperOptions::audit) it is computed from forces alone, so a force
// that is not a gradient shows up as imbalance. Otherwise it is computed from the energies; the
// imbalance then shows that the step obeys its equations and that no term is missing, but says
// nothing about the forces.
#pragma once

namespace hepatica {

// Energies in nanojoule (g mm2/s2) at the end of the step; works and losses over the step.
struct EnergyLedger {
    double kinetic = 0.0;
    double elastic = 0.0;
    double grab = 0.0;             // stored in grab springs
    double tether = 0.0;           // stored in the springs of the surrounding tissue
    double contact = 0.0;          // stored in the pads of tools and between surfaces
    double cohesion = 0.0;         // stored in the bonds between parted joints
    double gravity_work = 0.0;     // done on the body during the step
    double tool_work = 0.0;        // done by moving targets during the step, by cuts before it
    double damping_loss = 0.0;     // >= 0
    double friction_loss = 0.0;    // >= 0
    double integrator_loss = 0.0;  // of backward Euler for a body of constant stiffness: (|change
                                   // of velocity|_M^2 + |motion|_K^2) / 2, >= 0
    double nonlinear_loss = 0.0;   // because forces change along the step otherwise than its
                                   // equations assume: their work along the straight path from
                                   // start to end, less the work of the mean of start and end
                                   // force; third order in the step where the stiffness is exact,
                                   // of either sign
    double limiter_loss = 0.0;     // taken from the velocities where the step would have created
                                   // energy
    double tear_loss = 0.0;        // fracture: given up for good by the ties between parted joints
    double inversion_recovery_loss = 0.0;  // given up where inverted elements were restored
    double solver_work = 0.0;              // done by the residual forces of the linear solver, and
                                           // by E of eq. (11) where it is used
    double imbalance = 0.0;                // what does not add up; 0 up to rounding
};

// kinetic + elastic + grab + tether + contact + cohesion [nJ].
double stored_energy(const EnergyLedger& ledger);
// gravity_work + tool_work [nJ].
double work_put_in(const EnergyLedger& ledger);
// The change of stored_energy that all terms but the imbalance explain [nJ].
double explained_change(const EnergyLedger& ledger);

// The ledger of two steps, `second` after `first`: energies of the end, sums of works and losses.
EnergyLedger in_sequence(const EnergyLedger& first, const EnergyLedger& second);

// Sum of the absolute values of all terms but the imbalance [nJ].
double energy_handled(const EnergyLedger& ledger);
// |imbalance| / energy_handled(); 0 where both are 0.
double relative_imbalance(const EnergyLedger& ledger);

}  // namespace hepatica
