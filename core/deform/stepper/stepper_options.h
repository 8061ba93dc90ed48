// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of a stepper that trade accuracy for speed, apart from mesh and time step. Some
// can be changed while it runs, see Stepper::set_options.
#pragma once

#include "core/deform/body/body.h"
#include "core/deform/solvers/linear_solver.h"

namespace hepatica {

struct StepperOptions {
    ElementModel model = ElementModel::corotated;
    ElementOrder order = ElementOrder::linear;
    LinearSolverKind solver = LinearSolverKind::automatic;
    SolveLimits linear{};            // of each linear solve
    int newton_iterations = 1;       // 1: the linearly implicit step of eq. (12)
    double newton_tolerance = 1e-6;  // stop when no node moves further, in mean edge lengths
    int substeps = 1;                // per step()
    // The most per step() while a body swings back after it was let go, see SwingSubsteps; 1: as
    // many as `substeps`. Without effect where `published` is set.
    int swing_substeps = 6;
    // E of eq. (11), from `DampingFit::error`, added to the damping in the matrix of the first
    // iterate, where it multiplies the change of velocity only. It adds no damping force and does
    // not change the solution to which Newton's method converges. It may be negative; its effect is
    // limited so that at least a tenth of inertia and stiffness remains and the matrix stays
    // positive definite.
    RayleighDamping velocity_error{};
    // Adds the rotational stiffness of taut elements and the lateral stiffness of collapsed ones to
    // the matrix of a step, see TensionStiffness and CollapseStiffness, so that such a step need
    // not be shortened. Only for `corotated` with one iterate, on the processor; otherwise without
    // effect.
    bool tension = true;
    // Makes the published step unchanged, even where it creates energy. Otherwise such a step is
    // shortened, which the report says.
    bool published = false;
    // Makes the steps on the processor even where the scene is played on a device.
    bool on_processor = false;
    // Skips the steps of a body whose nodes have all moved slower than 1e-5 mean edge lengths per
    // second for half a second of simulated time, until a force or the state changes. Other options
    // that change meanwhile wake nothing, so that a dial that is turned moves nothing that rests:
    // they act with the next motion.
    bool sleeping = true;
    // Computes nonlinear_loss of each step by integrating the forces along its path, so that a
    // force that is not the gradient of its energy appears as imbalance (see energy_ledger.h). For
    // studies and tests: it evaluates all elements at least five more times per step, and up to 257
    // times.
    bool audit = false;
};

}  // namespace hepatica
