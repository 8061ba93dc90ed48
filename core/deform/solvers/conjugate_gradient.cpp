// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/conjugate_gradient.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/deform/solvers/finite_answer.h"
#include "core/deform/solvers/node_loops.h"

namespace hepatica {

namespace {

// Whether the Lanczos matrix of the iteration so far, less `shift`, is positive definite.
bool all_above(double shift, std::span<const double> steps, std::span<const double> ratios) {
    double pivot = 1.0 / steps[0] - shift;
    for (std::size_t k = 1; k < steps.size() && pivot > 0.0; ++k) {
        const double coupling_squared = ratios[k - 1] / (steps[k - 1] * steps[k - 1]);
        pivot = 1.0 / steps[k] + ratios[k - 1] / steps[k - 1] - shift - coupling_squared / pivot;
    }
    return pivot > 0.0;
}

// Smallest eigenvalue of that matrix to 1 %, from below. It is at most `upper`.
double smallest_eigenvalue(double upper, std::span<const double> steps,
                           std::span<const double> ratios) {
    double lower = upper;
    while (!all_above(lower, steps, ratios)) lower *= 0.7;
    if (lower == upper) return upper;
    upper = lower / 0.7;
    while (upper > 1.01 * lower) {
        const double middle = std::sqrt(lower * upper);
        (all_above(middle, steps, ratios) ? lower : upper) = middle;
    }
    return lower;
}

// Upper bound of the squared energy-norm error after steps.size() iterations, in units of (r, z).
double radau_factor(double eigenvalue, std::span<const double> steps,
                    std::span<const double> ratios) {
    double factor = 1.0 / eigenvalue;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const double excess = std::max(factor - steps[k], 0.0);
        factor = excess / (eigenvalue * excess + ratios[k]);
    }
    return factor;
}

// How much smaller than the smallest Ritz value the smallest eigenvalue is taken to be.
constexpr double eigenvalue_margin = 0.8;

// Factor by which the value of earlier solves grows at each solve, because the matrix has changed.
constexpr double relaxation = 1.02;

// Follows the spectrum and the error bound of one solve.
class ErrorBound {
  public:
    explicit ErrorBound(double known_smallest) : known_(known_smallest) {}

    // Factor of (r, z) that bounds the squared error before the first iteration.
    double before() const { return known_ > 0.0 ? 1.0 / (eigenvalue_margin * known_) : INFINITY; }

    // The same after each iteration, given its alpha and beta.
    double after(double step, double ratio) {
        steps_.push_back(step);
        ratios_.push_back(ratio);
        if (steps_.size() >= next_check_) update_spectrum();
        const std::size_t done = std::exchange(factor_size_, steps_.size());
        if (done == 0) return factor_ = radau_factor(eigenvalue_, steps_, ratios_);
        const double excess = std::max(factor_ - step, 0.0);
        return factor_ = excess / (eigenvalue_ * excess + ratio);
    }

    // Smallest Ritz value of this solve and of the earlier ones it was told of.
    double smallest() const { return known_ > 0.0 ? std::min(known_, ritz_) : ritz_; }

  private:
    void update_spectrum() {
        // After many iterations the Ritz value changes little, so it is computed less often.
        next_check_ = steps_.size() + 1 + steps_.size() / 16;
        const double upper = std::min(ritz_, 1.0 / steps_[0]);
        ritz_ = smallest_eigenvalue(upper, steps_, ratios_);
        history_.push_back({steps_.size(), ritz_});
        double eigenvalue = eigenvalue_margin * smallest();
        if (known_ == 0.0 || ritz_ < known_) {
            // While it falls, assume that it falls again by as much as since half the iterations.
            const auto half = std::lower_bound(
                history_.begin(), history_.end(), steps_.size() / 2,
                [](const auto& entry, std::size_t size) { return entry.first < size; });
            const double fall = steps_.size() < 4 ? 0.3 : ritz_ / half->second;
            eigenvalue *= fall * fall;
        }
        if (eigenvalue == eigenvalue_) return;
        eigenvalue_ = eigenvalue;
        factor_size_ = 0;
    }

    double known_;
    double ritz_ = INFINITY;
    double eigenvalue_ = 0.0;
    std::size_t next_check_ = 1;
    std::vector<double> steps_, ratios_;
    std::vector<std::pair<std::size_t, double>> history_;  // iterations, Ritz value
    double factor_ = 0.0;
    std::size_t factor_size_ = 0;
};

}  // namespace

SolveReport ConjugateGradient::solve(const BlockMatrix& matrix, const Preconditioner& precondition,
                                     std::span<const Vec3> rhs, std::span<Vec3> x,
                                     const SolveLimits& limits) {
    const auto apply = [&](const std::vector<Vec3>& a, std::vector<Vec3>& product) {
        multiply(matrix, a, product);
    };
    return solve(apply, precondition, rhs, x, limits);
}

SolveReport ConjugateGradient::solve(const Product& apply, const Preconditioner& precondition,
                                     std::span<const Vec3> rhs, std::span<Vec3> x,
                                     const SolveLimits& limits) {
    SolveReport report;
    const double rhs_squared = dot(rhs, rhs);
    if (!(rhs_squared > 0.0) || !std::isfinite(rhs_squared)) {
        std::fill(x.begin(), x.end(), Vec3::Zero());
        report.converged = rhs_squared == 0.0;
        report.relative_residual = report.energy_error = report.converged ? 0.0 : 1.0;
        return report;
    }
    direction_.assign(x.begin(), x.end());
    residual_.assign(rhs.begin(), rhs.end());
    double solution_energy = 0.0;  // |x|_A squared, so far
    const double warm_work = dot(direction_, rhs);
    if (warm_work != 0.0) {
        // Scaled to minimise the error in the energy norm, so a warm start is never worse than
        // zero.
        apply(direction_, product_);
        const double warm_energy = dot(direction_, product_);
        const double scale = warm_energy > 0.0 ? warm_work / warm_energy : 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] = scale * x[i];
            residual_[i] -= scale * product_[i];
        }
        solution_energy = scale * warm_work;
    } else {
        std::fill(x.begin(), x.end(), Vec3::Zero());
    }

    precondition(residual_, preconditioned_);
    direction_ = preconditioned_;
    double work = dot(residual_, preconditioned_);
    double residual_squared = dot(residual_, residual_);
    ErrorBound bound(relaxation * smallest_ritz_);
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
        apply(direction_, product_);
        const double curvature = dot(direction_, product_);
        if (!(curvature > 0.0) || !std::isfinite(curvature)) break;
        const double step = work / curvature;
        residual_squared =
            parallel_sum(x.size(), nodes_per_block, [&](std::size_t b, std::size_t e) {
                double sum = 0.0;
                for (std::size_t i = b; i < e; ++i) {
                    x[i] += step * direction_[i];
                    residual_[i] -= step * product_[i];
                    sum += residual_[i].squaredNorm();
                }
                return sum;
            });
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
