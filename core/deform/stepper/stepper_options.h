// SPDX-License-Identifier: GPL-3.0-or-later
// The dial's coordinates, apart from the mesh and the length of the step: what a stepper is made
// with, and what can be changed while it plays.
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
    double newton_tolerance = 1e-6;  // largest move of an iterate that ends them, in mean edges
    int substeps = 1;                // each step() is cut into so many
    // E of eq. (11) as `DampingFit::error` gives it: added to the damping in the first iterate's
    // matrix, where it meets the change of velocity alone. It damps nothing and changes no answer
    // that Newton's method converges to. It may be negative; a matrix that would no longer be
    // positive definite keeps a tenth of its inertia and stiffness.
    RayleighDamping velocity_error{};
    // The step exactly as published: whole, even where it makes energy. Otherwise a step that would
    // is shortened, and the report says so.
    bool published = false;
    // Skip the steps of a body that has not moved faster than 1e-5 mean edges a second for half a
    // second of its time, until something changes.
    bool sleeping = true;
    // Each step's nonlinear_loss is computed from the forces on its way, so that a force that is no
    // gradient of its energy shows up as imbalance (see energy_ledger.h). For studies and tests: it
    // evaluates all elements five times more a step, and up to some hundred times.
    bool audit = false;
};

}  // namespace hepatica
