// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/cholesky_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/deform/solvers/elimination_order.h"
#include "core/deform/solvers/finite_answer.h"
#include "core/deform/solvers/node_loops.h"

namespace hepatica {
namespace {

// Where the single-precision factor needs more iterations than this, double precision is used.
constexpr int most_polishing_iterations = 10;

// A factor sees nothing of the residual at pivots that it has dropped, so that it cannot tell the
// error there: the residual stands for it.
SolveReport with_dropped(SolveReport report, const SolveLimits& limits) {
    if (report.dropped_pivots == 0) return report;
    report.energy_error = std::max(report.energy_error, std::min(1.0, report.relative_residual));
    report.converged = report.converged && (report.energy_error <= limits.energy_tolerance ||
                                            report.relative_residual <= limits.residual_tolerance);
    return report;
}

}  // namespace

EliminationTree CholeskySolver::analyse(const BlockMatrix& pattern) {
    return hepatica::analyse(pattern, fill_reducing_order(pattern));
}

void CholeskySolver::plan(const BlockMatrix& pattern, EliminationTree analysis) {
    tree_ = std::move(analysis);
    single_.reset();
    begin(pattern);
}

// Starts over with the analysis in tree_, in single precision.
void CholeskySolver::begin(const BlockMatrix& pattern) {
    planned_rows_ = pattern.row_begin;
    planned_columns_ = pattern.column;
    double_.reset();
    in_double_ = factored_ = false;
    iteration_.forget();
}

// Depends only on the whole body's pattern and on parents_, not on the order in which it tore.
EliminationTree CholeskySolver::analysis_of_split(const BlockMatrix& pattern) const {
    EliminationTree tree = tree_of_split(whole_, parents_);
    if (tree.multiplications <= most_fill * whole_.multiplications) return tree;
    return hepatica::analyse(pattern, order_of_split(order_, parents_));
}

void CholeskySolver::plan_anew(const BlockMatrix& pattern) {
    if (parents_.empty()) {
        order_ = fill_reducing_order(pattern);
        return plan(pattern, hepatica::analyse(pattern, order_));
    }
    tree_ = analysis_of_split(pattern);
    if (single_) single_->plan(pattern, tree_);
    begin(pattern);
}

void CholeskySolver::plan_ahead(const BlockMatrix& pattern) {
    if (!planned_for(pattern)) plan_anew(pattern);
    if (!in_double_ && !single_) single_.emplace(pattern, tree_);
}

void CholeskySolver::follow_split(const BlockMatrix& pattern, std::span<const int> parents) {
    if (parents_.empty()) {
        if (order_.empty() || !planned_for(pattern)) plan_anew(pattern);
        whole_ = tree_;
    }
    parents_.assign(parents.begin(), parents.end());
}

template <class T>
void CholeskySolver::factor(std::optional<TreeFactor<T>>& factor,
                            std::span<const int> changed_rows) {
    if (!factor) factor.emplace(*matrix_, tree_);
    if (factored_)
        factor->refactor(*matrix_, changed_rows, stop());
    else
        factor->factor(*matrix_, stop());
    factored_ = true;
}

void CholeskySolver::update(const BlockMatrix& matrix, std::span<const Vec3>,
                            std::span<const int> changed_rows) {
    matrix_ = &matrix;
    product_known_ = false;
    if (!planned_for(matrix)) plan_anew(matrix);
    if (in_double_)
        factor(double_, changed_rows);
    else
        factor(single_, changed_rows);
}

int CholeskySolver::eliminated() const {
    return in_double_ ? (double_ ? double_->eliminated() : 0)
                      : (single_ ? single_->eliminated() : 0);
}

std::size_t CholeskySolver::bytes() const {
    return (single_ ? single_->bytes() : 0) + (double_ ? double_->bytes() : 0);
}

SolveReport CholeskySolver::polish(SolveReport direct,
                                   const ConjugateGradient::Preconditioner& precondition,
                                   std::span<const Vec3> rhs, std::span<Vec3> x,
                                   const SolveLimits& limits) {
    SolveReport report = iteration_.solve(*matrix_, precondition, rhs, x, limits, stop());
    report.method = direct.method;
    report.dropped_pivots = direct.dropped_pivots;
    return report;
}

// Relative error of x in the energy norm; `energy` is x . A x. The residual must be known. Uses a
// bound where that is good enough, because the estimate costs another substitution.
template <class T>
double CholeskySolver::energy_error(TreeFactor<T>& factor, double energy,
                                    const SolveLimits& limits) {
    const double bound = std::sqrt(most_inverse_form(residual_) / energy);
    if (bound <= limits.energy_tolerance) return bound;
    return std::min(1.0, std::sqrt(factor.inverse_form(residual_) / energy));
}

// x from the factor, improved by conjugate gradients until it meets the limits.
template <class T>
SolveReport CholeskySolver::solve_by(TreeFactor<T>& factor, std::span<const Vec3> rhs,
                                     std::span<Vec3> x, const SolveLimits& limits) {
    SolveReport report;
    report.method = name();
    report.dropped_pivots = factor.dropped_pivots();
    product_known_ = false;
    factor.solve(rhs, x);
    residual_.assign(x.begin(), x.end());
    multiply(*matrix_, residual_, product_);
    for_each_node(rhs.size(), [&](std::size_t i) { residual_[i] = rhs[i] - product_[i]; });
    const double rhs_squared = dot(rhs, rhs), energy = dot(rhs, x);
    report.relative_residual =
        rhs_squared == 0.0 ? 0.0 : std::sqrt(dot(residual_, residual_) / rhs_squared);
    report.energy_error = energy > 0.0 ? energy_error(factor, energy, limits) : 0.0;
    report.converged =
        std::isfinite(rhs_squared) && std::isfinite(energy) &&
        (report.relative_residual == 0.0 || report.energy_error <= limits.energy_tolerance ||
         report.relative_residual <= limits.residual_tolerance);
    report = with_dropped(report, limits);
    if (report.converged) {
        own_up_unless_finite(report, x);
        product_known_ = report.converged;
        if (report.converged) return report;
    }
    const auto precondition = [&](const std::vector<Vec3>& r, std::vector<Vec3>& z) {
        z.resize(r.size());
        factor.solve(r, z);
    };
    return with_dropped(polish(report, precondition, rhs, x, limits), limits);
}

SolveReport CholeskySolver::solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                                  const SolveLimits& limits) {
    if (!in_double_) {
        SolveLimits short_limits = limits;
        short_limits.max_iterations = std::min(limits.max_iterations, most_polishing_iterations);
        const SolveReport report = solve_by(*single_, rhs, x, short_limits);
        const bool told_to_stop = report.iterations >= limits.max_iterations;
        if ((report.converged && report.dropped_pivots == 0) || told_to_stop) return report;
        if (!std::isfinite(dot(rhs, rhs))) return report;  // no factor has an answer to that
        single_.reset();
        in_double_ = true;
        factored_ = false;
        factor(double_, {});
    }
    return solve_by(*double_, rhs, x, limits);
}

void CholeskySolver::precondition(const std::vector<Vec3>& r, std::vector<Vec3>& z) {
    z.resize(r.size());
    if (in_double_)
        double_->solve(r, z);
    else
        single_->solve(r, z);
}

std::vector<double> CholeskySolver::memory() const {
    return {in_double_ ? 1.0 : 0.0, iteration_.smallest_ritz()};
}

void CholeskySolver::restore(const BlockMatrix& pattern, bool made_from_it, std::span<const Vec3>,
                             std::span<const double> memory) {
    require_memory(memory.size() == 2 && !made_from_it && (memory[0] == 0.0 || memory[0] == 1.0) &&
                   not_negative(memory[1]));
    if (!planned_for(pattern)) plan_anew(pattern);
    single_.reset();
    double_.reset();
    factored_ = false;
    in_double_ = memory[0] == 1.0;
    iteration_.remember(memory[1]);
}

}  // namespace hepatica
