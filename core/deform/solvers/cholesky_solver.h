// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse Cholesky factorisation. For a new matrix only the branches of the elimination tree whose
// rows have changed are factored again. The factor is in single precision, which halves the memory
// that a solve reads; conjugate gradients with residuals in double precision remove the rounding
// error. Once a matrix is too ill-conditioned for that, factors are in double precision from then
// on.
#pragma once

#include <optional>
#include <vector>

#include "core/deform/solvers/conjugate_gradient.h"
#include "core/deform/solvers/linear_solver.h"
#include "core/deform/solvers/tree_cholesky.h"

namespace hepatica {

class CholeskySolver final : public LinearSolver {
  public:
    // The symbolic analysis and the factor's memory.
    void plan_ahead(const BlockMatrix& pattern) override;
    void update(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                std::span<const int> changed_rows) override;
    void follow_split(const BlockMatrix& pattern, std::span<const int> parents) override;
    SolveReport solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                      const SolveLimits& limits) override;
    const std::vector<Vec3>* product() const override {
        return product_known_ ? &product_ : nullptr;
    }
    void precondition(const std::vector<Vec3>& r, std::vector<Vec3>& z) override;
    std::string_view name() const override { return name_of(LinearSolverKind::cholesky); }

    // False: the factor is always that of the latest matrix.
    bool made_from_latest() const override { return false; }
    std::vector<double> memory() const override;
    void restore(const BlockMatrix& pattern, bool made_from_it, std::span<const Vec3> positions_mm,
                 std::span<const double> memory) override;

    // The symbolic analysis of a pattern; allocates no factor.
    static EliminationTree analyse(const BlockMatrix& pattern);
    // Uses the given analysis; the next update must name all rows as changed.
    void plan(const BlockMatrix& pattern, EliminationTree analysis);

    const EliminationTree& tree() const { return tree_; }
    // Supernodes eliminated by the last update.
    int eliminated() const;
    // Size of the factor.
    std::size_t bytes() const;
    bool in_single_precision() const { return !in_double_; }

    // A torn body's pattern is analysed from scratch once its factor takes more than this many
    // times the multiplications of the whole body's.
    static constexpr double most_fill = 1.25;

  private:
    bool planned_for(const BlockMatrix& pattern) const {
        return planned_rows_ == pattern.row_begin && planned_columns_ == pattern.column;
    }
    void plan_anew(const BlockMatrix& pattern);
    EliminationTree analysis_of_split(const BlockMatrix& pattern) const;
    void begin(const BlockMatrix& pattern);
    template <class T>
    void factor(std::optional<TreeFactor<T>>& factor, std::span<const int> changed_rows);
    template <class T>
    SolveReport solve_by(TreeFactor<T>& factor, std::span<const Vec3> rhs, std::span<Vec3> x,
                         const SolveLimits& limits);
    template <class T>
    double energy_error(TreeFactor<T>& factor, double energy, const SolveLimits& limits);
    SolveReport polish(SolveReport direct, const ConjugateGradient::Preconditioner& precondition,
                       std::span<const Vec3> rhs, std::span<Vec3> x, const SolveLimits& limits);

    const BlockMatrix* matrix_ = nullptr;
    std::vector<int> planned_rows_, planned_columns_;  // of the analysed pattern
    // The body before it was split: its order of elimination and its analysis; parents_: how it was
    // split.
    std::vector<int> order_, parents_;
    EliminationTree whole_;
    EliminationTree tree_;
    bool factored_ = false;  // with tree_: later updates need only the changed rows
    std::optional<TreePreconditioner> single_;
    std::optional<TreeCholesky> double_;
    bool in_double_ = false;
    ConjugateGradient iteration_;
    std::vector<Vec3> residual_, product_;
    bool product_known_ = false;
};

}  // namespace hepatica
