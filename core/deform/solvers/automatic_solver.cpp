// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/automatic_solver.h"

namespace hepatica {

namespace {

// Multiplications of a factorisation per block of the matrix up to which it is the quicker way to
// an energy error of 1 %, by the rows of `bench iterations`.
constexpr double most_multiplications_per_block = 3000.0;

}  // namespace

void AutomaticSolver::prepare(const BlockMatrix& matrix, std::span<const Vec3> positions_mm) {
    if (chosen_ == nullptr || planned_rows_ != matrix.row_begin) {
        planned_rows_ = matrix.row_begin;
        cholesky_.plan(matrix);
        const double per_block =
            cholesky_.factor().tree().multiplications / static_cast<double>(matrix.column.size());
        chosen_ = &skeleton_;
        if (per_block <= most_multiplications_per_block) chosen_ = &cholesky_;
    }
    chosen_->prepare(matrix, positions_mm);
}

}  // namespace hepatica
