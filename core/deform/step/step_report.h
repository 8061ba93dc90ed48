// SPDX-License-Identifier: GPL-3.0-or-later
// What one step says of itself: its effort, its error, its energies, and whether it had to be
// shortened.
#pragma once

#include <string>

#include "core/deform/body/energy_ledger.h"
#include "core/deform/potentials/self_load.h"
#include "core/deform/potentials/tool.h"
#include "core/tear/tear_state.h"

namespace hepatica {

struct StepReport {
    double dt_s = 0.0;
    int newton_iterations = 0;
    int linear_solves = 0;             // systems solved; bounded, see BackwardEuler::advance
    int linear_iterations = 0;         // 0 for a direct solve
    double linear_residual = 0.0;      // relative, achieved
    double linear_energy_error = 0.0;  // relative estimate in the energy norm, achieved
    int dropped_pivots = 0;            // the most of a solve, see SolveReport
    bool degraded = false;   // a line search failed, a solve broke down or the budget ran out
    bool predicted = false;  // the first iterate began where no change of velocity would have led
    bool shortened = false;  // less than the whole of the last direction was taken
    bool asleep = false;     // nothing moved: the step was skipped
    std::string message;     // why degraded, in words
    EnergyLedger energy;
    ToolLoad tool;           // at the end of the step; of a sleeping body that of its last
    SelfLoad self;           // as `tool`
    ObstacleLoad obstacles;  // as `tool`
    SelfCost self_cost, obstacle_cost;
    TearReport tear;  // at the end of the step, where the body may tear
    // Where surfaces may touch: see MomentumBalance.
    double momentum_error_g_mm_per_s = 0.0, momentum_exchanged_g_mm_per_s = 0.0;
    // Of an audited step: what its energies have lost more than its forces have worked on the way,
    // which is part of the ledger's imbalance; and how exactly that work is known.
    double audit_gap_nj = 0.0;
    double audit_error_nj = 0.0;
};

// The second step after the first: efforts summed, errors the larger.
StepReport in_sequence(const StepReport& first, const StepReport& second);

}  // namespace hepatica
