// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/automatic_solver.h"

namespace hepatica {

namespace {

// Multiplications of a factorisation per block of the matrix up to which it is the quicker way to
// an energy error of 1 %, by the rows of `bench iterations`.
constexpr double most_multiplications_per_block = 3000.0;

}  // namespace

void AutomaticSolver::choose(const BlockMatrix& pattern) {
    if (chosen_ != nullptr && planned_rows_ == pattern.row_begin) return;
    planned_rows_ = pattern.row_begin;
    if (!cholesky_) cholesky_.emplace(skeleton_, rest_positions_mm_);
    EliminationTree analysis = cholesky_->analyse(pattern);
    const double per_block = analysis.multiplications / static_cast<double>(pattern.column.size());
    if (per_block <= most_multiplications_per_block) {
        two_level_.reset();
        cholesky_->plan(pattern, std::move(analysis));
        chosen_ = &*cholesky_;
        return;
    }
    cholesky_.reset();
    two_level_.emplace(skeleton_, rest_positions_mm_);
    chosen_ = &*two_level_;
}

void AutomaticSolver::prepare(const BlockMatrix& matrix, std::span<const Vec3> positions_mm) {
    choose(matrix);
    chosen_->prepare(matrix, positions_mm);
}

// The choice follows from the pattern; nothing is kept before there was one.
std::vector<double> AutomaticSolver::memory() const {
    return chosen_ == nullptr ? std::vector<double>{} : chosen_->memory();
}

void AutomaticSolver::restore(const BlockMatrix* made_from, std::span<const Vec3> positions_mm,
                              std::span<const double> memory) {
    require_memory((made_from == nullptr) == memory.empty());
    if (made_from == nullptr) {
        chosen_ = nullptr;
        return;
    }
    choose(*made_from);
    chosen_->restore(made_from, positions_mm, memory);
}

}  // namespace hepatica
