// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of all solvers of the step's linear system, A dv = rhs of eq. (12). Each solve
// reports its iterations, residual and error in the energy norm.
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
    // Pivots dropped by the factorisation because its matrix was not positive definite; 0 for
    // solvers that do not factor the matrix.
    int dropped_pivots = 0;
    std::string_view method;  // the method that was used ("skeleton", ...)
};

// The matrix must be symmetric positive definite. A vertex whose off-diagonal blocks are all zero
// or absent counts as fixed or unconnected. Not thread-safe; loops inside run in parallel and give
// the same bits for any number of threads.
class LinearSolver {
  public:
    virtual ~LinearSolver() = default;

    // From now on update() and solve() throw Cancelled soon after a stop is requested: within an
    // iteration or a few eliminated columns. After that only restore() may be called next, which
    // ignores the stop.
    void heed(const std::stop_token& stop) { stop_ = stop; }

    // Promises that every later matrix is at least share * diag(least[i] I), in the sense of
    // positive semidefinite differences. Then r . A^-1 r is at most the sum of |r_i|^2 / (share
    // least[i]), by which a solver may know that it is done without another substitution. Kept by
    // reference; empty: no such bound is known.
    void bound_below(std::span<const double> least, double share) {
        least_ = least;
        share_ = share;
    }

    // Sets the matrix and the current position of each vertex. The matrix is kept by reference and
    // must stay unchanged and alive until the next call. `changed_rows` must name every row with a
    // block that differs from the last matrix.
    virtual void update(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                        std::span<const int> changed_rows) = 0;
    // Does now what depends on the pattern alone, so that the first update costs no more than later
    // ones. Changes no result and not memory(); keeps no reference.
    virtual void plan_ahead(const BlockMatrix& /*pattern*/) {}
    // update() with all rows named as changed.
    void prepare(const BlockMatrix& matrix, std::span<const Vec3> positions_mm);

    // Solves A x = rhs. On entry x is the warm start, or zeros. A matrix or a right-hand side that
    // is not finite gives a finite x that is reported as not converged.
    virtual SolveReport solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                              const SolveLimits& limits) = 0;

    // A x of the last solution if the solve computed it, else null. Valid until the next update()
    // or solve().
    virtual const std::vector<Vec3>* product() const { return nullptr; }

    // z approximates A^-1 r by an operator that is symmetric, positive semidefinite and constant
    // until the next update(); for iterations on a matrix close to this one. May prepare what
    // solve() would have prepared, but does not otherwise change later results.
    virtual void precondition(const std::vector<Vec3>& r, std::vector<Vec3>& z) = 0;
    // Reports a solve of the last matrix that used precondition() alone, by which a solver that
    // keeps a preconditioner may know that it is worn out. Changes no result before the next
    // update().
    virtual void wear(const SolveReport& /*solved*/) {}

    // Tells that nodes of the body were split: node i comes from parents[i], a smaller number, or
    // is an original node where parents[i] == i. `pattern` is that of the matrices so far; in later
    // ones the new nodes follow the others. Solvers that order the nodes keep the order of the
    // original ones.
    virtual void follow_split(const BlockMatrix& /*pattern*/, std::span<const int> /*parents*/) {}

    virtual std::string_view name() const = 0;

    // State carried from one matrix to the next: a factor or preconditioner of an earlier matrix,
    // and `memory()`, the numbers that decide when it is computed again.

    // Whether that factor or preconditioner is of the latest matrix. False for solvers without one.
    virtual bool made_from_latest() const = 0;
    virtual std::vector<double> memory() const = 0;
    // Restores that state: takes the numbers and, if `made_from_it`, computes the factor or
    // preconditioner from this matrix and these positions; otherwise only the pattern of the matrix
    // is used. Later solves have the same bits as those of the solver that gave the numbers. The
    // next update must name all rows. Throws InputError and changes nothing where the numbers
    // cannot be those of such a solver.
    virtual void restore(const BlockMatrix& matrix, bool made_from_it,
                         std::span<const Vec3> positions_mm, std::span<const double> memory) = 0;

  protected:
    const std::stop_token& stop() const { return stop_; }
    // Passes stop and bound on to a solver that does this one's work.
    void hand_on_to(LinearSolver& other) const {
        other.stop_ = stop_;
        other.least_ = least_;
        other.share_ = share_;
    }
    // An upper bound of r . A^-1 r; infinite where none is known.
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
// Whether it may be a tolerance or a Ritz value: finite, and 0 or more.
bool not_negative(double value);

// Conjugate gradients preconditioned by the inverse 3x3 diagonal blocks.
std::unique_ptr<LinearSolver> make_block_jacobi_solver();

// Makes a solver for a body. `rest_positions_mm` are the positions that the skeleton was made for,
// one per vertex. An empty skeleton (see skeleton_of_mesh) is an InputError for `skeleton`, and for
// `automatic` once it chooses the two-level method.
std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind,
                                                 const CoarseSkeleton& skeleton,
                                                 std::span<const Vec3> rest_positions_mm);

}  // namespace hepatica
