// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/energy_ledger.h"

#include <algorithm>
#include <cmath>

namespace hepatica {

EnergyLedger in_sequence(const EnergyLedger& first, const EnergyLedger& second) {
    EnergyLedger sum = second;
    sum.gravity_work += first.gravity_work;
    sum.tool_work += first.tool_work;
    sum.damping_loss += first.damping_loss;
    sum.integrator_loss += first.integrator_loss;
    sum.unfolding_loss += first.unfolding_loss;
    sum.solver_work += first.solver_work;
    sum.imbalance += first.imbalance;
    return sum;
}

StepReport in_sequence(const StepReport& first, const StepReport& second) {
    StepReport both = second;
    both.dt_s += first.dt_s;
    both.newton_iterations += first.newton_iterations;
    both.linear_iterations += first.linear_iterations;
    both.linear_residual = std::max(first.linear_residual, second.linear_residual);
    both.linear_energy_error = std::max(first.linear_energy_error, second.linear_energy_error);
    both.degraded = first.degraded || second.degraded;
    if (both.message.empty()) both.message = first.message;
    both.energy = in_sequence(first.energy, second.energy);
    return both;
}

double energy_handled(const EnergyLedger& ledger) {
    return ledger.kinetic + ledger.elastic + ledger.grab + std::abs(ledger.gravity_work) +
           std::abs(ledger.tool_work) + std::abs(ledger.damping_loss) +
           std::abs(ledger.integrator_loss) + std::abs(ledger.unfolding_loss) +
           std::abs(ledger.solver_work);
}

double relative_imbalance(const EnergyLedger& ledger) {
    const double size = energy_handled(ledger);
    return size > 0.0 ? std::abs(ledger.imbalance) / size : 0.0;
}

}  // namespace hepatica
