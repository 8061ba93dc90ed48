// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/block_jacobi.h"

#include <Eigen/LU>
#include <cmath>

#include "core/base/parallel.h"

namespace hepatica {

namespace {
constexpr std::size_t jacobi_rows_per_block = 1024;
}

std::vector<Mat3> inverse_diagonal(const BlockMatrix& matrix) {
    std::vector<Mat3> inverse(static_cast<std::size_t>(matrix.rows()));
    parallel_blocks(inverse.size(), jacobi_rows_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Mat3& block = matrix.block[matrix.diagonal[i]];
            inverse[i] = block.inverse();
            if (!(block.determinant() > 0.0) || !inverse[i].allFinite()) inverse[i].setZero();
        }
    });
    return inverse;
}

void BlockJacobiSolver::update(const BlockMatrix& matrix, std::span<const Vec3>,
                               std::span<const int>) {
    matrix_ = &matrix;
    inverse_ = inverse_diagonal(matrix);
}

SolveReport BlockJacobiSolver::solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                                     const SolveLimits& limits) {
    const auto inverse = [this](const std::vector<Vec3>& r, std::vector<Vec3>& z) {
        precondition(r, z);
    };
    SolveReport report = iteration_.solve(*matrix_, inverse, rhs, x, limits, stop());
    report.method = name();
    return report;
}

void BlockJacobiSolver::precondition(const std::vector<Vec3>& r, std::vector<Vec3>& z) {
    z.resize(r.size());
    parallel_blocks(r.size(), jacobi_rows_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) z[i] = inverse_[i] * r[i];
    });
}

std::vector<double> BlockJacobiSolver::memory() const {
    return {iteration_.smallest_ritz()};
}

void BlockJacobiSolver::restore(const BlockMatrix&, bool made_from_it, std::span<const Vec3>,
                                std::span<const double> memory) {
    require_memory(!made_from_it && memory.size() == 1 && not_negative(memory[0]));
    iteration_.remember(memory[0]);
}

}  // namespace hepatica
