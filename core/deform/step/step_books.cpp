// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/step_books.h"

#include "core/deform/solvers/node_loops.h"

namespace hepatica {
namespace {

// The quadrature of an audit is refined until its error is this share of the energies.
constexpr double audit_tolerance = 1e-7;

}  // namespace

double kinetic_energy(const Body& body, const std::vector<Vec3>& velocities_mm_per_s) {
    return sum_over_nodes(velocities_mm_per_s.size(), [&](std::size_t i) {
        return 0.5 * body.mass_g[i] * velocities_mm_per_s[i].squaredNorm();
    });
}

EnergyLedger StepBooks::energies(const BodyState& state, const PotentialList& potentials) const {
    EnergyLedger ledger;
    ledger.kinetic = kinetic_energy(body_, state.velocities_mm_per_s);
    ledger.elastic = potential_.elastic_energy();
    potentials.book(state.positions_mm, state.positions_mm, ledger);
    return ledger;
}

void StepBooks::book(StepUnderway& step, NewtonStep& newton, bool audit, StepReport& report) {
    const double dt = step.dt_s;
    EnergyLedger& ledger = report.energy;
    ledger.kinetic = kinetic_energy(body_, step.velocity);
    ledger.elastic = potential_.elastic_energy();
    step.potentials.book(step.positions, step.start.positions_mm, ledger);
    ledger.damping_loss =
        dt * (2.0 * body_.damping.alpha_per_s * ledger.kinetic + step.damping_form);
    const auto along_motion = [&](const std::vector<Vec3>& force) {
        return sum_over_nodes(force.size(),
                              [&](std::size_t i) { return dt * step.velocity[i].dot(force[i]); });
    };
    double start_work = step.linearised.start_force;
    double end_work = start_work - step.linearised.curvature;
    ledger.solver_work = step.linearised.residual;
    if (!step.whole) {
        newton.find_damping(step);
        potential_.descent(step, residual_);
        ledger.solver_work = -dot(step.velocity, residual_);
        start_work = along_motion(step.start_force);
        end_work = along_motion(potential_.force());
    }
    const double inertial_loss = sum_over_nodes(step.velocity.size(), [&](std::size_t i) {
        return 0.5 * body_.mass_g[i] *
               (step.velocity[i] - step.start.velocities_mm_per_s[i]).squaredNorm();
    });
    ledger.integrator_loss = inertial_loss + 0.5 * (start_work - end_work);
    const double gained = stored_energy(ledger) - stored_energy(step.before);
    // A moving tool has done the work that friction would take from a body that does not move.
    ledger.tool_work = step.before.friction_loss;
    // Work of elements and potentials along the path: from energies, or in an audit from forces.
    double path_work = ledger.gravity_work - (ledger.friction_loss - step.before.friction_loss) -
                       (gained - (ledger.kinetic - step.before.kinetic));
    if (audit) {
        if (!path_work_) path_work_ = std::make_unique<PathWork>(potential_.assembly());
        const double size = stored_energy(step.before) + energy_handled(ledger);
        const PathWork::Result way =
            path_work_->along(step.start.positions_mm, step.positions, step.potentials,
                              audit_tolerance * size, step.stop);
        report.audit_gap_nj = path_work - way.work_nj;
        path_work = way.work_nj;
        report.audit_error_nj = way.error_nj;
    }
    ledger.nonlinear_loss = path_work - 0.5 * (start_work + end_work);
    ledger.imbalance = gained - explained_change(ledger);
}

}  // namespace hepatica
