// SPDX-License-Identifier: GPL-3.0-or-later
// One interface for every way to solve the step's linear system, A dv = rhs of eq. (12), with the
// error that was reached: iterations, residual and energy-norm error are always reported.
#pragma once

#include <memory>
#include <span>
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
    // Pivots that vanished in the factorisation of this matrix or of the one its factor is of: it
    // was not positive definite. 0 where the matrix itself is not factored.
    int dropped_pivots = 0;
    std::string_view method;  // of the solver that did it ("skeleton", ...)
};

// The matrix is symmetric positive definite. A vertex whose off-diagonal blocks are all zero (or
// absent) counts as fixed or free of the rest. Not thread-safe; loops inside run in parallel and
// give the same bits for any number of threads.
class LinearSolver {
  public:
    virtual ~LinearSolver() = default;

    // Takes a matrix and the current position of each vertex. The matrix is kept by reference and
    // must stay unchanged and alive until the next one. `changed_rows`: every row with a block that
    // differs from the matrix before; what is left out may be taken to be as it was.
    virtual void update(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                        std::span<const int> changed_rows) = 0;
    // The same for a matrix of which nothing is known.
    void prepare(const BlockMatrix& matrix, std::span<const Vec3> positions_mm);

    // Solves A x = rhs. On entry x is the warm start (zeros where there is none). A matrix or a
    // right-hand side that is not finite gives a finite x that is reported as not converged.
    virtual SolveReport solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                              const SolveLimits& limits) = 0;

    virtual std::string_view name() const = 0;

    // What is carried from one matrix to the next: something made of an earlier matrix (a factor,
    // a preconditioner), and the few numbers that say when it is to be made anew.

    // Whether that something was made of the latest matrix. False where a solver makes nothing
    // that it keeps.
    virtual bool made_from_latest() const = 0;
    virtual std::vector<double> memory() const = 0;
    // Takes the numbers, and makes it anew of the matrix and positions that it was last made of
    // where `made_from_it`; otherwise the matrix is only a pattern. What follows has the bits of
    // the solver that gave the numbers; the next update must name all rows. Throws InputError where
    // the numbers cannot be those of such a solver, and then changes nothing.
    virtual void restore(const BlockMatrix& matrix, bool made_from_it,
                         std::span<const Vec3> positions_mm, std::span<const double> memory) = 0;
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
