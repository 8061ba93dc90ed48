// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/step_report.h"

#include <algorithm>

namespace hepatica {

StepReport in_sequence(const StepReport& first, const StepReport& second) {
    StepReport both = second;
    both.dt_s += first.dt_s;
    both.newton_iterations += first.newton_iterations;
    both.linear_solves += first.linear_solves;
    both.linear_iterations += first.linear_iterations;
    both.linear_residual = std::max(first.linear_residual, second.linear_residual);
    both.linear_energy_error = std::max(first.linear_energy_error, second.linear_energy_error);
    both.dropped_pivots = std::max(first.dropped_pivots, second.dropped_pivots);
    both.degraded = first.degraded || second.degraded;
    both.shortened = first.shortened || second.shortened;
    if (both.message.empty()) both.message = first.message;
    both.energy = in_sequence(first.energy, second.energy);
    both.tool.impulse_un_s += first.tool.impulse_un_s;
    both.self.contacts = std::max(first.self.contacts, second.self.contacts);
    both.self.least_gap_mm = std::min(first.self.least_gap_mm, second.self.least_gap_mm);
    SelfLoad& touch = both.obstacles.touch;
    touch.contacts = std::max(first.obstacles.touch.contacts, touch.contacts);
    touch.least_gap_mm = std::min(first.obstacles.touch.least_gap_mm, touch.least_gap_mm);
    both.obstacles.impulse_un_s += first.obstacles.impulse_un_s;
    both.self_cost.step_ms += first.self_cost.step_ms;
    both.obstacle_cost.step_ms += first.obstacle_cost.step_ms;
    both.momentum_error_g_mm_per_s += first.momentum_error_g_mm_per_s;
    both.momentum_exchanged_g_mm_per_s += first.momentum_exchanged_g_mm_per_s;
    both.audit_gap_nj += first.audit_gap_nj;
    both.audit_error_nj += first.audit_error_nj;
    return both;
}

}  // namespace hepatica
