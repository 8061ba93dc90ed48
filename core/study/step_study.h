// SPDX-License-Identifier: GPL-3.0-or-later
// Cost and error of one step of a whole vessel tree, on one thread and on several.
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
    double longest_ms = 0.0;         // 95th percentile
    double iterations = 0.0;         // of the linear solver, mean
    double newton_iterations = 0.0;  // mean; 1 unless a step had to be shortened
    double energy_error = 0.0;       // largest estimate of any step's linear solve
    double ledger_imbalance = 0.0;   // largest, relative to the energies handled
    std::uint64_t hash = 0;          // of the last state
};

struct StepStudyOptions {
    int tetrahedra = 25000;
    int frames = 240;  // of 1/60 s
    std::vector<int> threads{1, 2};
    double gravity_mm_s2 = 0.0;       // along -z
    double tether_pa_per_mm2 = 20.0;  // of the surrounding tissue, as in scenes
    VesselTree tree;                  // empty: the symmetric tree of 63 branches
};

// Clamps the tree at its roots and leads the vertex furthest from them around a circle of 2 mm
// radius. All of it is computed in every step: linear tetrahedra, a linear error of 1 %, one
// iterate a frame. The steps of all rows alternate in batches, so that disturbances affect all
// alike. Throws Cancelled.
std::vector<StepRow> study_steps(const StepStudyOptions& options, Job& job);

}  // namespace hepatica
