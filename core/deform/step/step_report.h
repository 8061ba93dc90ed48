// SPDX-License-Identifier: GPL-3.0-or-later
// The report of one step: its effort, its errors, its energies, and whether it had to be shortened.
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
    int linear_solves = 0;             // bounded, see BackwardEuler::advance
    int linear_iterations = 0;         // 0 for a direct solve
    double linear_residual = 0.0;      // relative, achieved
    double linear_energy_error = 0.0;  // relative estimate in the energy norm, achieved
    int dropped_pivots = 0;            // largest of any solve, see SolveReport
    bool degraded = false;   // a line search failed, a solve broke down or the budget ran out
    bool predicted = false;  // the first iterate started from the present velocity, not from 0
    bool shortened = false;  // the last direction was not taken whole
    bool asleep = false;     // nothing moved: the step was skipped
    std::string message;     // why degraded, in words
    EnergyLedger energy;
    ToolLoad tool;           // at the end of the step; of a sleeping body at that of its last
    SelfLoad self;           // as `tool`
    ObstacleLoad obstacles;  // as `tool`
    SelfCost self_cost, obstacle_cost;
    TearReport tear;  // at the end of the step, where the body may tear
    // Where surfaces may touch: see MomentumBalance.
    double momentum_error_g_mm_per_s = 0.0, momentum_exchanged_g_mm_per_s = 0.0;
    // In an audited step, the energy lost minus the work of the forces along the path, which is
    // part of the ledger's imbalance, and the estimated error of that work.
    double audit_gap_nj = 0.0;
    double audit_error_nj = 0.0;
};

// The report of two steps, `second` after `first`: efforts summed, the larger errors.
StepReport in_sequence(const StepReport& first, const StepReport& second);

}  // namespace hepatica
