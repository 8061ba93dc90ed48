// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of all solvers of the step's linear system, A dv = rhs of eq. (12). Each reports
// its iterations, residual and error in the energy norm.
#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/deform/solvers/block_matrix.h"
#include "core/deform/solvers/coarse_skeleton.h"

namespace hepatica {

// A solve stops at the first limit that it meets. A tolerance of 0 is no limit.
struct SolveLimits {
    double energy_tolerance = 1e-2;   // on |x - x_exact|_A / |x_exact|_A, estimated
    double residual_tolerance = 0.0;  // on |b - A x| / |b|
    int max_iterations = 10000;
    bool operator==(const SolveLimits&) const = default;
};

struct SolveReport {
    int iterations = 0;              // 0 for a direct solve
    double relative_residual = 0.0;  // |b - A x| / |b|, achieved
    double energy_error = 0.0;       // estimate of |x - x_exact|_A / |x_exact|_A, achieved
    bool converged = false;          // a tolerance was met before max_iterations
    // Pivots dropped by the factorisation in use because its matrix was not positive definite; 0
    // for solvers that do not factor the matrix.
    int dropped_pivots = 0;
    std::string_view method;  // of the solver that did it ("skeleton", ...)
};

// The matrix is symmetric positive definite. A vertex whose off-diagonal blocks are all zero (or
// absent) counts as fixed or free of the rest. Not thread-safe; loops inside run in parallel and
// give the same bits for any number of threads.
class LinearSolver {
  public:
    virtual ~LinearSolver() = default;

    // From now on update() and solve() throw Cancelled soon after a stop was asked for: within an
    // iteration, or while some columns are eliminated. Of a solver that threw only restore() may be
    // called next, which hears no stop.
    void heed(const std::stop_token& stop) { stop_ = stop; }

    // The matrices to come are share * least[i] times the unit block at each vertex i, and what is
    // positive semidefinite beside: |r|_A^-1 is then at most |r| in the inverse of that, by which a
    // solver may tell that it is done without another substitution. Kept by reference; empty: no
    // such bound is known.
    void bound_below(std::span<const double> least, double share) {
        least_ = least;
        share_ = share;
    }

    // Takes a matrix and the current position of each vertex. The matrix is kept by reference and
    // must stay unchanged and alive until the next call. `changed_rows` must name every row with a
    // block that differs from the last matrix.
    virtual void update(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                        std::span<const int> changed_rows) = 0;
    // The same with all rows named as changed.
    void prepare(const BlockMatrix& matrix, std::span<const Vec3> positions_mm);

    // Solves A x = rhs. On entry x is the warm start (zeros where there is none). A matrix or a
    // right-hand side that is not finite gives a finite x that is reported as not converged.
    virtual SolveReport solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                              const SolveLimits& limits) = 0;

    // A x of the last answer, where solving came by it; else null. Until the next update() or
    // solve().
    virtual const std::vector<Vec3>* product() const { return nullptr; }

    // z near A^-1 r, by an operator that is symmetric, positive semidefinite and the same until the
    // next update(): for iterations on a matrix that is near this one. Changes no later answer but
    // by preparing what solve() would have prepared.
    virtual void precondition(const std::vector<Vec3>& r, std::vector<Vec3>& z) = 0;

    // Some nodes of the body were split: node i from parents[i], a smaller number, or from none
    // where that is i. `pattern` is that of the matrices until now; those to come have the new
    // nodes behind the others. Solvers that order the nodes keep the order of those they know.
    virtual void follow_split(const BlockMatrix& /*pattern*/, std::span<const int> /*parents*/) {}

    virtual std::string_view name() const = 0;

    // State carried from one matrix to the next: a factor or preconditioner of an earlier matrix,
    // and `memory()`, the numbers that decide when it is computed anew.

    // Whether that factor or preconditioner is of the latest matrix. False for solvers without one.
    virtual bool made_from_latest() const = 0;
    virtual std::vector<double> memory() const = 0;
    // Restores that state: takes the numbers and, where `made_from_it`, computes the factor or
    // preconditioner from this matrix and these positions; otherwise the matrix gives the pattern
    // only. Later solves have the same bits as those of the solver that gave the numbers. The next
    // update must name all rows. Throws InputError, and changes nothing, where the numbers cannot
    // be those of such a solver.
    virtual void restore(const BlockMatrix& matrix, bool made_from_it,
                         std::span<const Vec3> positions_mm, std::span<const double> memory) = 0;

  protected:
    const std::stop_token& stop() const { return stop_; }
    // The same for another solver, which does this one's work.
    void hand_on_to(LinearSolver& other) const {
        other.stop_ = stop_;
        other.least_ = least_;
        other.share_ = share_;
    }
    // At least r . A^-1 r; infinite where no bound is known.
    double most_inverse_form(std::span<const Vec3> r) const;

  private:
    std::stop_token stop_;
    std::span<const double> least_;
    double share_ = 1.0;
};

enum class LinearSolverKind { block_jacobi, skeleton, cholesky, automatic };

// "block-jacobi", "skeleton", "cholesky", "automatic"; throws UsageError for another name.
LinearSolverKind linear_solver_kind(std::string_view name);
std::string_view name_of(LinearSolverKind kind);

// Throws the InputError of LinearSolver::restore where the condition does not hold.
void require_memory(bool condition);

// Conjugate gradients preconditioned by the inverse 3x3 diagonal blocks.
std::unique_ptr<LinearSolver> make_block_jacobi_solver();

// Makes a solver for a body. `rest_positions_mm` are those the skeleton was made for, one per
// vertex; an empty skeleton is an error for every kind but block_jacobi: use skeleton_of_mesh.
std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind,
                                                 const CoarseSkeleton& skeleton,
                                                 std::span<const Vec3> rest_positions_mm);

}  // namespace hepatica
