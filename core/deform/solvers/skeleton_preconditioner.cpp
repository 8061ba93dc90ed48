// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/skeleton_preconditioner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/stop.h"
#include "core/deform/solvers/elimination_order.h"

namespace hepatica {

namespace {

// Preparing costs about as much as this many iterations; measured.
constexpr int iterations_to_prepare = 3;
// A solve that needs this many more iterations than with a fresh preconditioner is interrupted.
constexpr int patience = 4;

// Nodes from the ends of the tree inward, the four vectors of a node together.
std::vector<int> coarse_order(const CoarseSkeleton& skeleton) {
    std::vector<int> order;
    for (const int node :
         order_from_ends(skeleton, bind_vertices(skeleton, skeleton.positions_mm))) {
        for (int k = 0; k < vectors_per_node; ++k) order.push_back(vectors_per_node * node + k);
    }
    return order;
}

}  // namespace

std::vector<char> lone_vertices(const BlockMatrix& matrix) {
    std::vector<char> lone(static_cast<std::size_t>(matrix.rows()), 1);
    parallel_blocks(lone.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1] && lone[i]; ++k) {
                if (k != matrix.diagonal[i] && !matrix.block[k].isZero(0.0)) lone[i] = 0;
            }
        }
    });
    return lone;
}

SkeletonPreconditioner::SkeletonPreconditioner(CoarseSkeleton skeleton,
                                               std::span<const Vec3> rest_positions_mm)
    : skeleton_(std::move(skeleton)) {
    if (skeleton_.size() == 0) {
        throw InputError("the skeleton has no node", "skeleton solver",
                         "Make one with skeleton_of_mesh, or use block-jacobi.");
    }
    validate(skeleton_);
    binding_ = bind_vertices(skeleton_, rest_positions_mm);
}

bool SkeletonPreconditioner::fits(const BlockMatrix& matrix) const {
    return planned_for(matrix) && lone_ == lone_vertices(matrix);
}

bool SkeletonPreconditioner::planned_for(const BlockMatrix& matrix) const {
    return space_ && planned_columns_ == matrix.column && planned_rows_ == matrix.row_begin;
}

void SkeletonPreconditioner::prepare(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                                     const std::stop_token& stop) {
    if (!planned_for(matrix)) {
        planned_columns_ = matrix.column;
        planned_rows_ = matrix.row_begin;
        space_.emplace(skeleton_, binding_, matrix);
        smoother_.emplace(matrix, order_from_ends(skeleton_, binding_));
        coarse_ = space_->coarse_pattern();
        coarse_factor_.emplace(coarse_, coarse_order(skeleton_));
    }
    throw_if_stopped(stop);
    smoother_->prepare(matrix);
    lone_ = lone_vertices(matrix);
    space_->set_shape(positions_mm, lone_);
    throw_if_stopped(stop);
    space_->project(matrix, coarse_);
    coarse_factor_->factor(coarse_, stop);
    remainder_.resize(positions_mm.size());
}

void SkeletonPreconditioner::apply(const std::vector<Vec3>& r, std::vector<Vec3>& z) {
    z.resize(r.size());
    smoother_->forward(r, z, remainder_);
    space_->restrict_to_nodes(remainder_, coarse_remainder_);
    coarse_factor_->solve(coarse_remainder_, coarse_remainder_);
    space_->add_motion(coarse_remainder_, z);
    smoother_->backward(r, z);
}

void SkeletonSolver::update(const BlockMatrix& matrix, std::span<const Vec3> positions_mm,
                            std::span<const int>) {
    matrix_ = &matrix;
    positions_mm_.assign(positions_mm.begin(), positions_mm.end());
    fresh_ = false;
    if (settings_.always_fresh || worn_ || !preconditioner_.fits(matrix)) prepare_anew();
}

void SkeletonSolver::prepare_anew() {
    preconditioner_.prepare(*matrix_, positions_mm_, stop());
    fresh_ = true;
    worn_ = false;
    spent_ = 0;
}

SolveReport SkeletonSolver::iterate(std::span<const Vec3> rhs, std::span<Vec3> x,
                                    const SolveLimits& limits) {
    const auto precondition = [this](const std::vector<Vec3>& r, std::vector<Vec3>& z) {
        preconditioner_.apply(r, z);
    };
    SolveReport report = iteration_.solve(*matrix_, precondition, rhs, x, limits, stop());
    report.method = name();
    return report;
}

SolveReport SkeletonSolver::solve(std::span<const Vec3> rhs, std::span<Vec3> x,
                                  const SolveLimits& limits) {
    if (!fresh_ && limits != fresh_limits_) prepare_anew();
    if (fresh_) {
        const SolveReport report = iterate(rhs, x, limits);
        fresh_limits_ = limits;
        fresh_iterations_ = report.iterations;
        worn_ = !report.converged;
        return report;
    }
    SolveLimits lagged = limits;
    lagged.max_iterations = std::min(limits.max_iterations, fresh_iterations_ + patience);
    SolveReport report = iterate(rhs, x, lagged);
    spent_ += std::max(0, report.iterations - fresh_iterations_);
    worn_ = spent_ >= iterations_to_prepare;
    if (report.converged || lagged.max_iterations == limits.max_iterations) return report;
    // The old preconditioner fits badly: prepare it again and continue from the current x. How many
    // iterations a solve with it takes from the start is not known then: the next matrix gets one
    // of its own, and with it a count. By the old count a body that has become harder for good
    // would be interrupted in every solve.
    const int iterations = report.iterations;
    prepare_anew();
    SolveLimits rest = limits;
    rest.max_iterations -= iterations;
    report = iterate(rhs, x, rest);
    report.iterations += iterations;
    worn_ = true;
    return report;
}

// Couplings alone may cost more iterations than that; even then a fresh preconditioner costs but a
// small part of such a solve.
void SkeletonSolver::wear(const SolveReport& solved) {
    if (!solved.converged || solved.iterations > fresh_iterations_ + patience) worn_ = true;
}

std::vector<double> SkeletonSolver::memory() const {
    return {worn_ ? 1.0 : 0.0,
            static_cast<double>(spent_),
            static_cast<double>(fresh_iterations_),
            static_cast<double>(fresh_limits_.max_iterations),
            fresh_limits_.energy_tolerance,
            fresh_limits_.residual_tolerance,
            iteration_.smallest_ritz()};
}

void SkeletonSolver::restore(const BlockMatrix& matrix, bool made_from_it,
                             std::span<const Vec3> positions_mm, std::span<const double> memory) {
    constexpr double most = std::numeric_limits<int>::max();
    require_memory(memory.size() == 7 && (made_from_it || memory[0] == 1.0) && memory[0] <= 1.0);
    for (int k = 0; k < 4; ++k)
        require_memory(memory[k] >= 0.0 && memory[k] <= most && memory[k] == std::floor(memory[k]));
    for (int k = 4; k < 7; ++k) require_memory(not_negative(memory[k]));
    if (made_from_it) preconditioner_.prepare(matrix, positions_mm);
    fresh_ = false;
    worn_ = memory[0] != 0.0;
    spent_ = static_cast<int>(memory[1]);
    fresh_iterations_ = static_cast<int>(memory[2]);
    fresh_limits_ = {.energy_tolerance = memory[4],
                     .residual_tolerance = memory[5],
                     .max_iterations = static_cast<int>(memory[3])};
    iteration_.remember(memory[6]);
}

}  // namespace hepatica
