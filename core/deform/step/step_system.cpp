// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/step/step_system.h"

#include <algorithm>
#include <numeric>

#include "core/deform/solvers/coupled_solve.h"
#include "core/deform/step/assemble_again.h"

namespace hepatica {

void StepSystem::heed(const std::stop_token& stop) {
    solver_->heed(stop);
    coupled_.heed(stop);
}

SolveReport StepSystem::solve(const StepUnderway& step, const CouplingBlocks& coupling,
                              double share, std::span<const Vec3> rhs, std::vector<Vec3>& x,
                              const SolveLimits& limits) {
    const BlockMatrix& matrix = potential_.matrix();
    const std::vector<std::uint8_t>& held = potential_.live().held();
    std::ranges::fill(x, Vec3::Zero());
    coupled_last_ = !coupling.empty();
    if (coupled_.pays(matrix, coupling)) {
        solver_unaware_ = true;
        coupled_.bound_below(body_.mass_g, share);
        return coupled_.solve(matrix, potential_.assembled_rows(), coupling, held, rhs, x, limits);
    }
    coupled_.forget_matrix();
    solver_->bound_below(body_.mass_g, share);
    // After the coupled factor was used, all rows count as changed, as they do for a solver that is
    // restored from a checkpoint: both give the same bits.
    std::vector<int> rows(potential_.assembled_rows().begin(), potential_.assembled_rows().end());
    if (std::exchange(solver_unaware_, false)) {
        rows.resize(static_cast<std::size_t>(matrix.rows()));
        std::iota(rows.begin(), rows.end(), 0);
    }
    solver_->update(matrix, step.positions, rows);
    if (coupling.empty()) return solver_->solve(rhs, x, limits);
    const auto add_coupling = [&](std::span<const Vec3> d, std::span<Vec3> product) {
        step.potentials.add_coupling(step.positions, step.dt_s * step.dt_s, d, product);
    };
    const SolveReport report =
        solve_coupled(*solver_, matrix, add_coupling, held, rhs, x, limits, step.stop);
    solver_->wear(report);
    return report;
}

SolverCheckpoint StepSystem::checkpoint() const {
    SolverCheckpoint kept = made_;
    kept.memory = solver_->memory();
    kept.coupled = coupled_.memory();
    return kept;
}

void StepSystem::restore(const SolverCheckpoint& checkpoint) {
    const std::optional<MatrixOrigin>& origin = checkpoint.made_from;
    const std::vector<std::uint8_t> held = potential_.live().held();
    const bool collapse = potential_.collapse_counts();
    const auto back_to_present = [&] {
        if (origin) potential_.freeze(held);
        potential_.count_collapse(collapse);
        potential_.forget_matrix();
    };
    CoupledFactor coupled;
    coupled.restore(potential_.matrix(), checkpoint.coupled);
    if (origin) assemble_again(body_, potential_, checkpoint);
    const std::vector<Vec3> none;
    const bool first = !origin || origin->iterate_mm.empty();
    try {
        solver_->restore(potential_.matrix(), origin.has_value(),
                         !origin ? none : (first ? origin->first_mm : origin->iterate_mm),
                         checkpoint.memory);
    } catch (...) {
        back_to_present();
        throw;
    }
    back_to_present();
    coupled_ = std::move(coupled);
    solver_unaware_ = false;
    made_ = checkpoint;
}

}  // namespace hepatica
