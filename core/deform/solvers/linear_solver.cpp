// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/linear_solver.h"

#include <array>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/deform/solvers/automatic_solver.h"
#include "core/deform/solvers/block_jacobi.h"
#include "core/deform/solvers/cholesky_solver.h"
#include "core/deform/solvers/node_loops.h"
#include "core/deform/solvers/skeleton_preconditioner.h"

namespace hepatica {

namespace {

struct Entry {
    LinearSolverKind kind;
    std::string_view name;
};

constexpr std::array<Entry, 4> entries{{{LinearSolverKind::block_jacobi, "block-jacobi"},
                                        {LinearSolverKind::skeleton, "skeleton"},
                                        {LinearSolverKind::cholesky, "cholesky"},
                                        {LinearSolverKind::automatic, "automatic"}}};

}  // namespace

LinearSolverKind linear_solver_kind(std::string_view name) {
    for (const Entry& entry : entries) {
        if (entry.name == name) return entry.kind;
    }
    throw UsageError("there is no linear solver \"" + std::string(name) + "\"", "",
                     "Choose block-jacobi, skeleton, cholesky or automatic.");
}

std::string_view name_of(LinearSolverKind kind) {
    return entries[static_cast<std::size_t>(kind)].name;
}

void LinearSolver::prepare(const BlockMatrix& matrix, std::span<const Vec3> positions_mm) {
    std::vector<int> all(static_cast<std::size_t>(matrix.rows()));
    std::iota(all.begin(), all.end(), 0);
    update(matrix, positions_mm, all);
}

double LinearSolver::most_inverse_form(std::span<const Vec3> r) const {
    if (least_.size() != r.size()) return INFINITY;
    return sum_over_nodes(r.size(), [&](std::size_t i) { return r[i].squaredNorm() / least_[i]; }) /
           share_;
}

void require_memory(bool condition) {
    if (!condition)
        throw InputError("is of another linear solver", "the checkpoint of a body",
                         "Make the stepper with the options that it was taken with");
}

bool not_negative(double value) {
    return value >= 0.0 && std::isfinite(value);
}

std::unique_ptr<LinearSolver> make_block_jacobi_solver() {
    return std::make_unique<BlockJacobiSolver>();
}

std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind,
                                                 const CoarseSkeleton& skeleton,
                                                 std::span<const Vec3> rest_positions_mm) {
    switch (kind) {
        case LinearSolverKind::skeleton:
            return std::make_unique<SkeletonSolver>(skeleton, rest_positions_mm);
        case LinearSolverKind::cholesky:
            return std::make_unique<CholeskySolver>();
        case LinearSolverKind::automatic:
            return std::make_unique<AutomaticSolver>(skeleton, rest_positions_mm);
        default:
            return make_block_jacobi_solver();
    }
}

}  // namespace hepatica
