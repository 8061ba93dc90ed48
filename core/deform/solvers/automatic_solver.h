// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses between factorisation and two-level iteration for each body, by their number of
// operations and the measured cost of an operation: thin trees are factored, bulky bodies iterated.
// It measures no time at run time, so that the same commands give the same bits. The choice needs
// only the symbolic analysis of the pattern; a rejected factor is never allocated.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/deform/solvers/cholesky_solver.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/deform/solvers/skeleton_preconditioner.h"

namespace hepatica {

class AutomaticSolver final : public LinearSolver {
  public:
    AutomaticSolver(const CoarseSkeleton& skeleton, std::span<const Vec3> rest_positions_mm)
        : skeleton_(skeleton),
          rest_positions_mm_(rest_positions_mm.begin(), rest_positions_mm.end()) {}

    void plan_ahead(const BlockMatrix& pattern) override {
        choose(pattern);
        chosen_->plan_ahead(pattern);
    }
    void update(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                std::span<const int> changed_rows) override;
    SolveReport solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                      const SolveLimits& limits) override {
        return chosen_->solve(rhs, x, limits);  // the report names the method used
    }
    const std::vector<Vec3>* product() const override {
        return chosen_ != nullptr ? chosen_->product() : nullptr;
    }
    void precondition(const std::vector<Vec3>& r, std::vector<Vec3>& z) override {
        chosen_->precondition(r, z);
    }
    void wear(const SolveReport& solved) override { chosen_->wear(solved); }
    std::string_view name() const override { return name_of(LinearSolverKind::automatic); }
    bool made_from_latest() const override { return chosen_->made_from_latest(); }
    std::vector<double> memory() const override;
    void restore(const BlockMatrix& matrix, bool made_from_it, std::span<const Vec3> positions_mm,
                 std::span<const double> memory) override;

    // Size of the factor; 0 where the factorisation was rejected.
    std::size_t factor_bytes() const {
        return chosen_ != nullptr && cholesky_ ? cholesky_->bytes() : 0;
    }

  private:
    void choose(const BlockMatrix& pattern);

    CoarseSkeleton skeleton_;
    std::vector<Vec3> rest_positions_mm_;
    std::optional<CholeskySolver> cholesky_;  // once chosen, exactly one of the two is set
    std::optional<SkeletonSolver> two_level_;
    LinearSolver* chosen_ = nullptr;
    bool updated_ = false;  // has seen a matrix, not only a pattern
    std::vector<int> planned_rows_;
};

}  // namespace hepatica
