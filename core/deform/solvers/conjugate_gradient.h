// SPDX-License-Identifier: GPL-3.0-or-later
// Preconditioned conjugate gradients that stop on the energy norm of the error, estimated from the
// iteration's own coefficients: the Gauss-Radau upper bound of Meurant and Tichy, with the smallest
// Ritz value of this and earlier solves in place of the unknown smallest eigenvalue.
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/deform/solvers/linear_solver.h"

namespace hepatica {

class ConjugateGradient {
  public:
    // z = M^-1 r for a symmetric positive definite M of the matrix's size.
    using Preconditioner = std::function<void(const std::vector<Vec3>& r, std::vector<Vec3>& z)>;
    // y = A x for a symmetric positive definite A.
    using Product = std::function<void(const std::vector<Vec3>& x, std::vector<Vec3>& y)>;

    // Forgets the smallest Ritz value of earlier solves.
    void forget() { smallest_ritz_ = 0.0; }
    // Continues with the smallest_ritz() of another solver.
    void remember(double smallest_ritz) { smallest_ritz_ = smallest_ritz; }

    // Throws Cancelled before the next iteration after a stop is requested; smallest_ritz() is then
    // unchanged.
    SolveReport solve(const BlockMatrix& matrix, const Preconditioner& precondition,
                      std::span<const Vec3> rhs, std::span<Vec3> x, const SolveLimits& limits,
                      const std::stop_token& stop = {});
    SolveReport solve(const Product& apply, const Preconditioner& precondition,
                      std::span<const Vec3> rhs, std::span<Vec3> x, const SolveLimits& limits,
                      const std::stop_token& stop = {});

    // Smallest Ritz value of M^-1 A in the solves so far, raised slightly at each solve because the
    // matrix changes; 0 before the first solve.
    double smallest_ritz() const { return smallest_ritz_; }

  private:
    double begin(const Product& apply, std::span<const Vec3> rhs, std::span<Vec3> x);
    double advance(double step, std::span<Vec3> x);

    double smallest_ritz_ = 0.0;  // 0 before the first solve
    std::vector<Vec3> residual_, direction_, product_, preconditioned_;
};

}  // namespace hepatica
