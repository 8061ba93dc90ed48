// SPDX-License-Identifier: GPL-3.0-or-later
// The number of iterations that each linear solver needs to reach a true error, over slenderness,
// mesh size and shape. The error is measured in the energy norm against the direct solution.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/deform/body/body.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// The system of one linearly implicit step, M + dt^2 K at a given shape, loaded by gravity and a
// pull at the vertex furthest from the clamp.
struct StudySystem {
    BlockMatrix matrix;
    std::vector<Vec3> positions_mm;
    std::vector<Vec3> rhs;
    std::vector<Vec3> exact;  // by Cholesky factorisation
};

// `bend_rad` 0: the shape at rest; otherwise bent by this angle, see bent().
StudySystem study_system(const BodyDescription& body, double bend_rad, double dt_s = 1.0 / 60.0);

// |x - exact|_A / |exact|_A
double energy_error(const StudySystem& system, const std::vector<Vec3>& x);

struct IterationRow {
    std::string body;
    std::string solver;
    double slenderness = 0.0;  // length over diameter, from clamp to furthest end
    int tetrahedra = 0;
    int iterations_10pct = 0;  // until the true error is below; 0 for a direct solve
    int iterations_1pct = 0;
    int iterations_stopped = 0;  // where the solver stopped by itself at an estimate of 1 %
    double estimate = 0.0;       // estimate of the error there
    double error = 0.0;          // true error there
    double prepare_ms = 0.0;     // least of several
    double ms = 0.0;             // preparation and iterations_1pct iterations, least of several
};

IterationRow measure_iterations(const std::string& name, const BodyDescription& body,
                                const StudySystem& system, double slenderness,
                                LinearSolverKind kind, const std::stop_token& stop = {});

struct IterationStudyOptions {
    VesselTree tree;           // a patient's, measured instead of the bars and symmetric trees
    int tetrahedra = 25000;    // approximate size of its mesh
    bool quick = false;        // two small bars only
    bool block_jacobi = true;  // for comparison; slow on long bodies
};

// Measures bars of slenderness 10 to 500 and trees of 8,000 to 100,000 tetrahedra, at rest and
// bent; or a patient's tree, at rest and bent about its roots, away from the line to its furthest
// end. Throws Cancelled.
std::vector<IterationRow> study_iterations(const IterationStudyOptions& options, Job& job);

}  // namespace hepatica
