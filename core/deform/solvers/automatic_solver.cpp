// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/automatic_solver.h"

namespace hepatica {

namespace {

// Up to this many multiplications per block of the matrix, a factorisation reaches an energy error
// of 1 % faster than iterations do; measured by `bench iterations`.
constexpr double most_multiplications_per_block = 3000.0;

}  // namespace

void AutomaticSolver::choose(const BlockMatrix& pattern) {
    if (chosen_ != nullptr && planned_rows_ == pattern.row_begin) return;
    planned_rows_ = pattern.row_begin;
    EliminationTree analysis = CholeskySolver::analyse(pattern);
    const double per_block = analysis.multiplications / static_cast<double>(pattern.column.size());
    if (per_block <= most_multiplications_per_block) {
        two_level_.reset();
        chosen_ = &cholesky_.emplace();
        cholesky_->plan(pattern, std::move(analysis));
        return;
    }
    cholesky_.reset();
    chosen_ = &two_level_.emplace(skeleton_, rest_positions_mm_);
}

void AutomaticSolver::update(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                             std::span<const int> changed_rows) {
    choose(matrix);
    updated_ = true;
    hand_on_to(*chosen_);
    chosen_->update(matrix, positions_mm, changed_rows);
}

// The choice depends on the pattern alone, so only the chosen solver's state is kept. Empty before
// the first matrix.
std::vector<double> AutomaticSolver::memory() const {
    return !updated_ ? std::vector<double>{} : chosen_->memory();
}

void AutomaticSolver::restore(const BlockMatrix& matrix, bool made_from_it,
                              std::span<const Vec3> positions_mm, std::span<const double> memory) {
    if (memory.empty()) {
        require_memory(!made_from_it);
        chosen_ = nullptr;
        updated_ = false;
        return choose(matrix);
    }
    choose(matrix);
    chosen_->restore(matrix, made_from_it, positions_mm, memory);
    updated_ = true;
}

}  // namespace hepatica
