// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/body/energy_ledger.h"

#include <cmath>

namespace hepatica {

double stored_energy(const EnergyLedger& ledger) {
    return ledger.kinetic + ledger.elastic + ledger.grab + ledger.tether + ledger.contact +
           ledger.cohesion;
}

double work_put_in(const EnergyLedger& ledger) {
    return ledger.gravity_work + ledger.tool_work;
}

double explained_change(const EnergyLedger& ledger) {
    return work_put_in(ledger) - ledger.damping_loss - ledger.friction_loss -
           ledger.integrator_loss - ledger.nonlinear_loss - ledger.limiter_loss - ledger.tear_loss -
           ledger.inversion_recovery_loss + ledger.solver_work;
}

EnergyLedger in_sequence(const EnergyLedger& first, const EnergyLedger& second) {
    EnergyLedger sum = second;
    sum.gravity_work += first.gravity_work;
    sum.tool_work += first.tool_work;
    sum.damping_loss += first.damping_loss;
    sum.friction_loss += first.friction_loss;
    sum.integrator_loss += first.integrator_loss;
    sum.nonlinear_loss += first.nonlinear_loss;
    sum.limiter_loss += first.limiter_loss;
    sum.tear_loss += first.tear_loss;
    sum.inversion_recovery_loss += first.inversion_recovery_loss;
    sum.solver_work += first.solver_work;
    sum.imbalance += first.imbalance;
    return sum;
}

double energy_handled(const EnergyLedger& ledger) {
    return stored_energy(ledger) + std::abs(ledger.gravity_work) + std::abs(ledger.tool_work) +
           std::abs(ledger.damping_loss) + std::abs(ledger.friction_loss) +
           std::abs(ledger.integrator_loss) + std::abs(ledger.nonlinear_loss) +
           std::abs(ledger.limiter_loss) + std::abs(ledger.tear_loss) +
           std::abs(ledger.inversion_recovery_loss) + std::abs(ledger.solver_work);
}

double relative_imbalance(const EnergyLedger& ledger) {
    const double size = energy_handled(ledger);
    return size > 0.0 ? std::abs(ledger.imbalance) / size : 0.0;
}

}  // namespace hepatica
