// SPDX-License-Identifier: GPL-3.0-or-later
// The exact end of the dial: a factorisation along the tree, kept from step to step. Only branches
// whose blocks changed are factored again; while the factor is close enough, it serves as the
// preconditioner of a few conjugate-gradient iterations instead.
#pragma once

#include <optional>
#include <vector>

#include "core/deform/solvers/conjugate_gradient.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/deform/solvers/tree_cholesky.h"

namespace hepatica {

struct CholeskySettings {
    // Factor at once what has changed, so that every solve is direct. Otherwise a factor serves
    // until its iterations have cost as much as factoring what has changed since.
    bool exact = false;
};

class CholeskySolver final : public LinearSolver {
  public:
    CholeskySolver(FrameSkeleton skeleton, std::span<const Vec3> rest_positions_mm,
                   const CholeskySettings& settings = {});

    // Finds by comparison what has changed since the factorisation.
    void prepare(const BlockMatrix& matrix, std::span<const Vec3> positions_mm) override;
    SolveReport solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                      const SolveLimits& limits) override;
    std::string_view name() const override { return name_of(LinearSolverKind::cholesky); }
    bool made_from_latest() const override { return exact_; }
    std::vector<double> memory() const override;
    void restore(const BlockMatrix* made_from, std::span<const Vec3> positions_mm,
                 std::span<const double> memory) override;

    // The elimination of a pattern, before any number is allocated.
    EliminationTree analyse(const BlockMatrix& pattern) const;
    // Allocates the factor of a pattern by that analysis of it.
    void plan(const BlockMatrix& pattern, EliminationTree analysis);
    const TreeCholesky& factor() const { return *factor_; }

  private:
    struct Change {
        std::vector<int> vertices;
        double size = 0.0;  // largest, relative to the diagonal blocks
    };
    Change change() const;
    bool planned_for(const BlockMatrix& pattern) const;
    void factor_anew();
    double iteration_cost() const;
    SolveReport solve_directly(std::span<const Vec3> rhs, std::span<Vec3> x);

    FrameBinding binding_;
    FrameSkeleton skeleton_;
    CholeskySettings settings_;
    const BlockMatrix* matrix_ = nullptr;
    std::optional<TreeCholesky> factor_;
    BlockMatrix factored_;  // the matrix as the factor knows it
    bool factored_once_ = false;
    bool exact_ = false;   // factor_ is that of *matrix_
    double spent_ = 0.0;   // on iterations that a fresh factor would have saved
    double change_ = 0.0;  // since the factorisation, and what it would cost to catch up
    double catch_up_ = 0.0;
    // Least change under which iterating was found to cost more than catching up; 0: none yet.
    double too_much_ = 0.0;
    ConjugateGradient iteration_;
    std::vector<Vec3> residual_;
};

}  // namespace hepatica
