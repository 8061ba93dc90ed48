// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses between factorisation and two-level iteration for each body by what their operations were
// measured to cost: thin trees are factored, bulky bodies iterated. Never by the clock, so that the
// same commands give the same bits.
#pragma once

#include "core/deform/solvers/cholesky_solver.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/deform/solvers/skeleton_preconditioner.h"

namespace hepatica {

class AutomaticSolver final : public LinearSolver {
  public:
    AutomaticSolver(const FrameSkeleton& skeleton, std::span<const Vec3> rest_positions_mm)
        : cholesky_(skeleton, rest_positions_mm), skeleton_(skeleton, rest_positions_mm) {}

    void prepare(const BlockMatrix& matrix, std::span<const Vec3> positions_mm) override;
    SolveReport solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                      const SolveLimits& limits) override {
        return chosen_->solve(rhs, x, limits);  // its report names the method
    }
    std::string_view name() const override { return name_of(LinearSolverKind::automatic); }
    bool made_from_latest() const override { return chosen_->made_from_latest(); }
    std::vector<double> memory() const override;
    void restore(const BlockMatrix* made_from, std::span<const Vec3> positions_mm,
                 std::span<const double> memory) override;

  private:
    void choose(const BlockMatrix& pattern);

    CholeskySolver cholesky_;
    SkeletonSolver skeleton_;
    LinearSolver* chosen_ = nullptr;
    std::vector<int> planned_rows_;
};

}  // namespace hepatica
