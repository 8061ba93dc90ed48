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
    double newton_tolerance = 1e-6;  // ends when no node moves farther, in mean edge lengths
    int substeps = 1;                // per step()
    // E of eq. (11), from `DampingFit::error`, added to the damping in the matrix of the first
    // iterate, where it multiplies the change of velocity only. It adds no damping force and does
    // not change the solution to which Newton's method converges. It may be negative; its effect is
    // limited so that at least a tenth of inertia and stiffness remains and the matrix stays
    // positive definite.
    RayleighDamping velocity_error{};
    // Adds to the matrix of a step what taut elements resist being turned and what collapsed ones
    // resist being widened, see TensionStiffness and CollapseStiffness: such a step need not be
    // shortened. `corotated` and one iterate only, on the processor; others are what they are
    // without.
    bool tension = true;
    // Takes the step of the publication unchanged, even where it creates energy. Otherwise such a
    // step is shortened, which the report says.
    bool published = false;
    // Where the scene is played on a device, the processor makes these steps all the same.
    bool on_processor = false;
    // Makes no steps of a body whose nodes have moved slower than 1e-5 mean edge lengths per second
    // for half a second of simulated time, until a force or option changes.
    bool sleeping = true;
    // Computes nonlinear_loss of each step by integrating the forces along its path, so that a
    // force that is not the gradient of its energy appears as imbalance (see energy_ledger.h). For
    // studies and tests: it evaluates all elements at least five more times per step, at most about
    // 100.
    bool audit = false;
};

}  // namespace hepatica
