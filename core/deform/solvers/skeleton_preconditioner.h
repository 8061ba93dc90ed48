// SPDX-License-Identifier: GPL-3.0-or-later
// Two-level preconditioner whose coarse grid is the vessel tree's own centreline: a Gauss-Seidel
// sweep, a correction by affine motions along the tree, and the adjoint sweep. The number of
// iterations hardly depends on the length of the vessels, the size of the mesh or how far they are
// bent.
#pragma once

#include <optional>
#include <vector>

#include "core/deform/solvers/affine_coarse_space.h"
#include "core/deform/solvers/conjugate_gradient.h"
#include "core/deform/solvers/gauss_seidel.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/deform/solvers/tree_cholesky.h"

namespace hepatica {

// Whether all off-diagonal blocks of each row are zero.
std::vector<char> lone_vertices(const BlockMatrix& matrix);

class SkeletonPreconditioner {
  public:
    // Throws InputError where the skeleton is empty or invalid.
    SkeletonPreconditioner(CoarseSkeleton skeleton, std::span<const Vec3> rest_positions_mm);

    // As LinearSolver::prepare. The first call, and a call with another pattern, plans anew. Throws
    // Cancelled after a stop is requested; it must then be prepared again.
    void prepare(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                 const std::stop_token& stop = {});

    // Whether it was prepared for a matrix of this pattern with the same lone vertices.
    bool fits(const BlockMatrix& matrix) const;

    // z = M^-1 r with M symmetric positive definite.
    void apply(const std::vector<Vec3>& r, std::vector<Vec3>& z);

    const AffineCoarseSpace& space() const { return *space_; }
    const TreeCholesky& coarse_factor() const { return *coarse_factor_; }

  private:
    bool planned_for(const BlockMatrix& matrix) const;

    std::vector<char> lone_;
    CoarseSkeleton skeleton_;
    SkeletonBinding binding_;
    std::vector<int> planned_columns_, planned_rows_;
    std::optional<AffineCoarseSpace> space_;
    std::optional<GaussSeidel> smoother_;
    std::optional<TreeCholesky> coarse_factor_;
    BlockMatrix coarse_;
    std::vector<Vec3> remainder_, coarse_remainder_;
};

struct SkeletonSettings {
    // Prepare for every matrix. Otherwise a preconditioner is kept until its additional iterations,
    // compared with a fresh one, have cost as much as preparing a fresh one. One that was made in
    // the middle of a solve serves that matrix alone.
    bool always_fresh = false;
};

class SkeletonSolver final : public LinearSolver {
  public:
    SkeletonSolver(CoarseSkeleton skeleton, std::span<const Vec3> rest_positions_mm,
                   const SkeletonSettings& settings = {})
        : settings_(settings), preconditioner_(std::move(skeleton), rest_positions_mm) {}

    void update(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                std::span<const int> changed_rows) override;
    SolveReport solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                      const SolveLimits& limits) override;
    void precondition(const std::vector<Vec3>& r, std::vector<Vec3>& z) override {
        preconditioner_.apply(r, z);
    }
    void wear(const SolveReport& solved) override;
    std::string_view name() const override { return name_of(LinearSolverKind::skeleton); }
    bool made_from_latest() const override { return fresh_; }
    std::vector<double> memory() const override;
    void restore(const BlockMatrix& matrix, bool made_from_it, std::span<const Vec3> positions_mm,
                 std::span<const double> memory) override;

  private:
    void prepare_anew();
    SolveReport iterate(std::span<const Vec3> rhs, std::span<Vec3> x, const SolveLimits& limits);

    SkeletonSettings settings_;
    const BlockMatrix* matrix_ = nullptr;
    std::vector<Vec3> positions_mm_;
    SkeletonPreconditioner preconditioner_;
    ConjugateGradient iteration_;
    bool fresh_ = false;          // the preconditioner is that of *matrix_
    bool worn_ = true;            // to be prepared again before the next solve
    SolveLimits fresh_limits_{};  // limits of the last solve that was fresh from its start
    int fresh_iterations_ = 0;    // iterations of that solve
    int spent_ = 0;               // additional iterations of all later solves
};

}  // namespace hepatica
