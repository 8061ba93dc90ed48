// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/cholesky_solver.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/deform/solvers/elimination_order.h"
#include "core/deform/solvers/finite_answer.h"
#include "core/deform/solvers/node_loops.h"

namespace hepatica {

namespace {

// A direct solve whose residual is larger than this is polished by conjugate gradients.
constexpr double good_residual = 1e-8;

// Work of one iteration counted in multiplications of a factorisation: reading an entry of the
// factor twice, and of the matrix once, costs as much as this many of them. Measured.
constexpr double per_factor_entry = 7.0;
constexpr double per_matrix_entry = 4.0;

// What was too much change to iterate over is raised by this much with each factorisation.
constexpr double forgetting = 1.02;

}  // namespace

CholeskySolver::CholeskySolver(FrameSkeleton skeleton, std::span<const Vec3> rest_positions_mm,
                               const CholeskySettings& settings)
    : skeleton_(std::move(skeleton)), settings_(settings) {
    if (skeleton_.size() == 0) {
        throw InputError("the skeleton has no node", "cholesky solver",
                         "Make one with skeleton_of_mesh, or use block-jacobi.");
    }
    validate(skeleton_);
    binding_ = bind_vertices(skeleton_, rest_positions_mm);
}

EliminationTree CholeskySolver::analyse(const BlockMatrix& pattern) const {
    return hepatica::analyse(pattern, order_from_ends(skeleton_, binding_));
}

bool CholeskySolver::planned_for(const BlockMatrix& pattern) const {
    return factor_ && factored_.column == pattern.column &&
           factored_.row_begin == pattern.row_begin;
}

void CholeskySolver::plan(const BlockMatrix& pattern, EliminationTree analysis) {
    factored_ = pattern;
    factor_.emplace(pattern, std::move(analysis));
    factored_once_ = false;
    iteration_.forget();
}

CholeskySolver::Change CholeskySolver::change() const {
    const BlockMatrix& a = *matrix_;
    std::vector<double> size(static_cast<std::size_t>(a.rows()), 0.0);
    std::vector<char> changed(size.size(), 0);
    parallel_blocks(size.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            double largest = 0.0;
            const int begin_row = a.row_begin[i], end_row = a.row_begin[i + 1];
            // To the bit, so that an exact factor is the one that this matrix would give.
            if (std::memcmp(&a.block[begin_row], &factored_.block[begin_row],
                            sizeof(Mat3) * static_cast<std::size_t>(end_row - begin_row)) == 0)
                continue;
            for (int k = begin_row; k < end_row; ++k) {
                const double difference = (a.block[k] - factored_.block[k]).squaredNorm();
                // Written so that NaN counts as a change.
                if (!(difference <= largest)) largest = difference;
            }
            const double scale = factored_.block[a.diagonal[i]].squaredNorm();
            size[i] = scale > 0.0 ? std::sqrt(largest / scale) : 1.0;
            changed[i] = 1;
        }
    });
    Change change;
    for (std::size_t i = 0; i < size.size(); ++i) {
        if (!changed[i]) continue;
        change.vertices.push_back(static_cast<int>(i));
        change.size = std::max(change.size, size[i]);
    }
    return change;
}

void CholeskySolver::factor_anew() {
    factored_.block = matrix_->block;
    factor_->factor(factored_);
    factored_once_ = true;
    exact_ = true;
    spent_ = 0.0;
}

void CholeskySolver::prepare(const BlockMatrix& matrix, std::span<const Vec3>) {
    matrix_ = &matrix;
    if (!planned_for(matrix)) plan(matrix, analyse(matrix));
    if (!factored_once_) return factor_anew();
    const Change found = change();
    exact_ = found.vertices.empty();
    if (exact_) return;
    change_ = found.size;
    catch_up_ = factor_->refactor_multiplications(found.vertices);
    const bool known_to_be_dear = too_much_ > 0.0 && !(change_ < too_much_);
    if (!settings_.exact && !known_to_be_dear && spent_ < catch_up_) return;
    for (const int v : found.vertices) {
        std::copy(matrix.block.begin() + matrix.row_begin[v],
                  matrix.block.begin() + matrix.row_begin[v + 1],
                  factored_.block.begin() + matrix.row_begin[v]);
    }
    factor_->refactor(factored_, found.vertices);
    exact_ = true;
    spent_ = 0.0;
    too_much_ *= forgetting;  // tried again now and then: the motion may be another one
}

double CholeskySolver::iteration_cost() const {
    return per_factor_entry * 9.0 * static_cast<double>(factor_->tree().factor_blocks) +
           per_matrix_entry * 9.0 * static_cast<double>(matrix_->column.size());
}

std::vector<double> CholeskySolver::memory() const {
    return {spent_, too_much_, iteration_.smallest_ritz()};
}

void CholeskySolver::restore(const BlockMatrix* made_from, std::span<const Vec3>,
                             std::span<const double> memory) {
    require_memory(memory.size() == 3);
    matrix_ = made_from;
    factored_once_ = false;
    if (made_from != nullptr) {
        if (!planned_for(*made_from)) plan(*made_from, analyse(*made_from));
        factor_anew();
    }
    spent_ = memory[0];
    too_much_ = memory[1];
    iteration_.remember(memory[2]);
}

SolveReport CholeskySolver::solve_directly(std::span<const Vec3> rhs, std::span<Vec3> x) {
    SolveReport report;
    report.method = name();
    report.dropped_pivots = factor_->dropped_pivots();
    factor_->solve(rhs, x);
    residual_.assign(x.begin(), x.end());
    std::vector<Vec3> product;
    multiply(*matrix_, residual_, product);
    for (std::size_t i = 0; i < rhs.size(); ++i) residual_[i] = rhs[i] - product[i];
    const double rhs_squared = dot(rhs, rhs);
    const double energy = dot(rhs, x);
    report.relative_residual =
        rhs_squared == 0.0 ? 0.0 : std::sqrt(dot(residual_, residual_) / rhs_squared);
    report.energy_error =
        energy > 0.0 ? std::min(1.0, std::sqrt(factor_->inverse_form(residual_) / energy)) : 0.0;
    report.converged = std::isfinite(rhs_squared) && report.relative_residual <= good_residual;
    own_up_unless_finite(report, x);
    return report;
}

SolveReport CholeskySolver::solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                                  const SolveLimits& limits) {
    if (exact_) {
        const SolveReport report = solve_directly(rhs, x);
        if (report.converged) return report;
    }
    const auto precondition = [this](const std::vector<Vec3>& r, std::vector<Vec3>& z) {
        z.resize(r.size());
        factor_->solve(r, z);
    };
    // Iterations that take longer than factoring anew would.
    const double cost = iteration_cost();
    const double affordable = factor_->tree().multiplications / cost;
    SolveLimits lagged = limits;
    lagged.max_iterations = std::min(limits.max_iterations, 3 + static_cast<int>(affordable));
    SolveReport report = iteration_.solve(*matrix_, precondition, rhs, x, lagged);
    report.method = name();
    report.dropped_pivots = factor_->dropped_pivots();
    const double extra = std::max(0, report.iterations - 1) * cost;
    spent_ += extra;
    if (!exact_ && extra > catch_up_) {
        too_much_ = too_much_ > 0.0 ? std::min(too_much_, change_) : change_;
    }
    if (report.converged || report.iterations >= limits.max_iterations || exact_) return report;
    const int iterations = report.iterations;
    factor_anew();
    report = solve_directly(rhs, x);
    report.iterations = iterations;
    return report;
}

}  // namespace hepatica
