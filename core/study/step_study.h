// SPDX-License-Identifier: GPL-3.0-or-later
// What one step of a whole vessel tree costs, on one core and on several, and with what error.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/job.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct StepRow {
    int threads = 0;
    int tetrahedra = 0;
    double ms = 0.0;                 // median step
    double longest_ms = 0.0;         // that 95 % of the steps stay below
    double iterations = 0.0;         // of the linear solver, mean
    double newton_iterations = 0.0;  // mean: 1 but where a step had to be shortened
    double energy_error = 0.0;       // largest estimate of any step's linear solve
    double ledger_imbalance = 0.0;   // largest, of the energies handled
    std::uint64_t hash = 0;          // of the last state
};

struct StepStudyOptions {
    int tetrahedra = 25000;
    int frames = 240;  // of 1/60 s
    std::vector<int> threads{1, 2};
    double gravity_mm_s2 = 0.0;       // along -z
    double tether_pa_per_mm2 = 20.0;  // of the tissue around, as scenes begin
    VesselTree tree;                  // empty: the symmetric tree of 63 branches
};

// The tree is clamped at its roots, and the vertex furthest from them is led around by 2 mm. All of
// it is computed in every step: linear tetrahedra, a linear error of 1 %, one iterate a frame. The
// rows' steps alternate in batches, so that what disturbs one disturbs the others.
std::vector<StepRow> study_steps(const StepStudyOptions& options, Job& job);

}  // namespace hepatica
