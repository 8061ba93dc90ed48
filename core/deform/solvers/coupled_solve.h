// SPDX-License-Identifier: GPL-3.0-or-later
// Solves (A + C) x = b, where the solver has A and C is known by its product with a vector alone:
// stiffness between surfaces that touch, which would ruin the pattern of A. Conjugate gradients on
// A + C, preconditioned by the solver. For contacts D between motions a and b of two surfaces A has
// a.D a + b.D b, and (a - b).D (a - b) <= 2 (a.D a + b.D b): no error is magnified by more than 2,
// and those that last are common motions of what touches, one for each contact at most.
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/deform/solvers/linear_solver.h"

namespace hepatica {

// Adds C d to a product.
using Coupling = std::function<void(std::span<const Vec3> d, std::span<Vec3> product)>;

// `solver` was given `matrix` last. A + C must be symmetric positive definite. As
// LinearSolver::solve; the solver's own memory of earlier solves stays as it is. Where no row is
// held, the common translation of all is solved for exactly at the end, so that the sum of the
// residual vanishes to rounding: no momentum is made or lost. Throws Cancelled within an iteration
// after a stop was asked for.
SolveReport solve_coupled(LinearSolver& solver, const BlockMatrix& matrix, const Coupling& coupling,
                          std::span<const std::uint8_t> held, std::span<const Vec3> rhs,
                          std::span<Vec3> x, const SolveLimits& limits,
                          const std::stop_token& stop = {});

// Corrects the common translation of an approximate solution x of (A + C) x = rhs as said above.
// Without a coupling it is that of A alone.
void keep_sum_of_residual(const BlockMatrix& matrix, const Coupling& coupling,
                          std::span<const std::uint8_t> held, std::span<const Vec3> rhs,
                          std::span<Vec3> x);

}  // namespace hepatica
