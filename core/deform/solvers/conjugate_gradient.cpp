// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/conjugate_gradient.h"

#include <algorithm>
#include <cmath>

#include "core/base/stop.h"
#include "core/deform/solvers/error_bound.h"
#include "core/deform/solvers/finite_answer.h"
#include "core/deform/solvers/node_loops.h"

namespace hepatica {

SolveReport ConjugateGradient::solve(const BlockMatrix& matrix, const Preconditioner& precondition,
                                     std::span<const Vec3> rhs, std::span<Vec3> x,
                                     const SolveLimits& limits, const std::stop_token& stop) {
    const auto apply = [&](const std::vector<Vec3>& a, std::vector<Vec3>& product) {
        multiply(matrix, a, product);
    };
    return solve(apply, precondition, rhs, x, limits, stop);
}

// Scales the warm start x to minimise its error in the energy norm, so that it is never worse than
// zero, and computes its residual. Returns |x|_A squared.
double ConjugateGradient::begin(const Product& apply, std::span<const Vec3> rhs,
                                std::span<Vec3> x) {
    direction_.assign(x.begin(), x.end());
    residual_.assign(rhs.begin(), rhs.end());
    const double warm_work = dot(direction_, rhs);
    if (warm_work == 0.0) {
        std::fill(x.begin(), x.end(), Vec3::Zero());
        return 0.0;
    }
    apply(direction_, product_);
    const double warm_energy = dot(direction_, product_);
    const double scale = warm_energy > 0.0 ? warm_work / warm_energy : 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = scale * x[i];
        residual_[i] -= scale * product_[i];
    }
    return scale * warm_work;
}

// One step along the direction, whose product with A is known. Returns |residual| squared.
double ConjugateGradient::advance(double step, std::span<Vec3> x) {
    return parallel_sum(x.size(), nodes_per_block, [&](std::size_t b, std::size_t e) {
        double sum = 0.0;
        for (std::size_t i = b; i < e; ++i) {
            x[i] += step * direction_[i];
            residual_[i] -= step * product_[i];
            sum += residual_[i].squaredNorm();
        }
        return sum;
    });
}

SolveReport ConjugateGradient::solve(const Product& apply, const Preconditioner& precondition,
                                     std::span<const Vec3> rhs, std::span<Vec3> x,
                                     const SolveLimits& limits, const std::stop_token& stop) {
    SolveReport report;
    const double rhs_squared = dot(rhs, rhs);
    if (!(rhs_squared > 0.0) || !std::isfinite(rhs_squared)) {
        std::fill(x.begin(), x.end(), Vec3::Zero());
        report.converged = rhs_squared == 0.0;
        report.relative_residual = report.energy_error = report.converged ? 0.0 : 1.0;
        return report;
    }
    double solution_energy = begin(apply, rhs, x);  // |x|_A squared of the current x

    precondition(residual_, preconditioned_);
    direction_ = preconditioned_;
    double work = dot(residual_, preconditioned_);
    double residual_squared = dot(residual_, residual_);
    ErrorBound bound(ErrorBound::relaxation * smallest_ritz_);
    double error_squared = bound.before() * work;
    const auto finished = [&] {
        const double energy_limit = limits.energy_tolerance * limits.energy_tolerance;
        const double residual_limit = limits.residual_tolerance * limits.residual_tolerance;
        // A semidefinite preconditioner may map a nonzero residual to zero.
        if (work == 0.0) error_squared = residual_squared > 0.0 ? INFINITY : 0.0;
        report.converged = (1.0 - energy_limit) * error_squared <= energy_limit * solution_energy ||
                           residual_squared <= residual_limit * rhs_squared ||
                           residual_squared == 0.0;
        return report.converged || report.iterations >= limits.max_iterations;
    };
    while (!finished()) {
        throw_if_stopped(stop);
        apply(direction_, product_);
        const double curvature = dot(direction_, product_);
        if (!(curvature > 0.0) || !std::isfinite(curvature)) break;
        const double step = work / curvature;
        residual_squared = advance(step, x);
        solution_energy += step * work;
        precondition(residual_, preconditioned_);
        const double new_work = dot(residual_, preconditioned_);
        if (!(new_work >= 0.0) || !std::isfinite(new_work)) break;  // M is not positive definite
        const double ratio = new_work / work;
        work = new_work;
        error_squared = bound.after(step, ratio) * work;
        ++report.iterations;
        parallel_blocks(x.size(), nodes_per_block, [&](std::size_t b, std::size_t e) {
            for (std::size_t i = b; i < e; ++i) {
                direction_[i] = preconditioned_[i] + ratio * direction_[i];
            }
        });
    }
    if (report.iterations > 0) smallest_ritz_ = bound.smallest();
    report.relative_residual = std::sqrt(residual_squared / rhs_squared);
    // |x_exact|_A^2 = |x|_A^2 + |x_exact - x|_A^2, because the error is A-orthogonal to x.
    report.energy_error =
        std::isfinite(error_squared)
            ? std::sqrt(error_squared / (std::max(solution_energy, 0.0) + error_squared))
            : 1.0;
    own_up_unless_finite(report, x);
    return report;
}

}  // namespace hepatica
