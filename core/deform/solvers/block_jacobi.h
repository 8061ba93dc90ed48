// SPDX-License-Identifier: GPL-3.0-or-later
// The usual preconditioner in real-time deformation: the inverse 3x3 diagonal block of each vertex.
// It is the baseline for comparisons and suits bulky bodies with heavy vertices.
#pragma once

#include <vector>

#include "core/deform/solvers/conjugate_gradient.h"
#include "core/deform/solvers/linear_solver.h"

namespace hepatica {

// Inverse diagonal blocks; zero for a block that is not positive definite.
std::vector<Mat3> inverse_diagonal(const BlockMatrix& matrix);

class BlockJacobiSolver final : public LinearSolver {
  public:
    void update(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                std::span<const int> changed_rows) override;
    SolveReport solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                      const SolveLimits& limits) override;
    void precondition(const std::vector<Vec3>& r, std::vector<Vec3>& z) override;
    std::string_view name() const override { return name_of(LinearSolverKind::block_jacobi); }
    bool made_from_latest() const override { return false; }
    std::vector<double> memory() const override;
    void restore(const BlockMatrix& matrix, bool made_from_it, std::span<const Vec3> positions_mm,
                 std::span<const double> memory) override;

  private:
    const BlockMatrix* matrix_ = nullptr;
    std::vector<Mat3> inverse_;
    ConjugateGradient iteration_;
};

}  // namespace hepatica
