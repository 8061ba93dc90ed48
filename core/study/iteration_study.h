// SPDX-License-Identifier: GPL-3.0-or-later
// How many iterations each linear solver takes to a true error, over slenderness, mesh size and
// shape. The error is that of the energy norm against the direct solution.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/deform/body/body.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// One linearly implicit step's system: M + dt^2 K at a shape, loaded by gravity and a pull at the
// vertex furthest from the clamp.
struct StudySystem {
    BlockMatrix matrix;
    std::vector<Vec3> positions_mm;
    std::vector<Vec3> rhs;
    std::vector<Vec3> exact;  // by factorisation, residual 1e-10 or less
};

// `bend_rad` 0: the shape at rest.
StudySystem study_system(const BodyDescription& body, double bend_rad, double dt_s = 1.0 / 60.0);

// |x - exact|_A / |exact|_A
double energy_error(const StudySystem& system, const std::vector<Vec3>& x);

struct IterationRow {
    std::string body;
    std::string solver;
    double slenderness = 0.0;  // length over diameter, of the body from clamp to furthest end
    int tetrahedra = 0;
    int iterations_10pct = 0;  // until the true error is below; 0 for a direct solve
    int iterations_1pct = 0;
    int iterations_stopped = 0;  // where the solver stopped by itself at an estimate of 1 %
    double estimate = 0.0;       // of the error there
    double error = 0.0;          // the true one there
    double prepare_ms = 0.0;     // least of several
    double ms = 0.0;             // preparation and iterations_1pct iterations, least of several
};

IterationRow measure_iterations(const std::string& name, const BodyDescription& body,
                                const StudySystem& system, double slenderness,
                                LinearSolverKind kind, const std::stop_token& stop = {});

struct IterationStudyOptions {
    VesselTree tree;           // a patient's: measured instead of the bars and symmetric trees
    int tetrahedra = 25000;    // of it, about
    bool quick = false;        // a few small bodies
    bool block_jacobi = true;  // the yardstick, slow on long bodies
};

// Bars of slenderness 10 to 500 and trees of 5,000 to 100,000 tetrahedra, at rest and bent. A
// patient's tree is bent about its roots, away from the line to its furthest end.
std::vector<IterationRow> study_iterations(const IterationStudyOptions& options, Job& job);

}  // namespace hepatica
