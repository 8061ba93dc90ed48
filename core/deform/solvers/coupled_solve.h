// SPDX-License-Identifier: GPL-3.0-or-later
// Solves (A + C) x = b, where a solver has A, and C, the stiffness between touching surfaces, is
// known only by its product with a vector, because its blocks would spoil the pattern of A.
// Conjugate gradients on A + C, preconditioned by the solver. For a contact stiffness D between the
// motions a and b of two surfaces, A contains a.D a + b.D b, and (a - b).D (a - b) <= 2 (a.D a +
// b.D b): eigenvalues of the preconditioned matrix are at most 2, and the small ones belong to
// common motions of touching surfaces, at most one per contact.
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/deform/solvers/linear_solver.h"

namespace hepatica {

// Adds C d to a product.
using Coupling = std::function<void(std::span<const Vec3> d, std::span<Vec3> product)>;

// As LinearSolver::solve. `solver` must have been given `matrix` last; its own state is not
// changed. A + C must be symmetric positive definite. Where no row is held, the common translation
// of all nodes is finally solved exactly, so that the sum of the residual vanishes up to rounding
// and momentum is conserved. Throws Cancelled within an iteration after a stop is requested.
SolveReport solve_coupled(LinearSolver& solver, const BlockMatrix& matrix, const Coupling& coupling,
                          std::span<const std::uint8_t> held, std::span<const Vec3> rhs,
                          std::span<Vec3> x, const SolveLimits& limits,
                          const std::stop_token& stop = {});

// Shifts an approximate solution x of (A + C) x = rhs by a common translation so that the sum of
// the residual vanishes, unless a row is held. An empty coupling means C = 0. Costs four products.
void keep_sum_of_residual(const BlockMatrix& matrix, const Coupling& coupling,
                          std::span<const std::uint8_t> held, std::span<const Vec3> rhs,
                          std::span<Vec3> x);

}  // namespace hepatica
