// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/coupled_solve.h"

#include <Eigen/LU>
#include <algorithm>

#include "core/deform/solvers/conjugate_gradient.h"

namespace hepatica {
namespace {

Vec3 sum_of(std::span<const Vec3> a) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& value : a) sum += value;
    return sum;
}

}  // namespace

void keep_sum_of_residual(const BlockMatrix& matrix, const Coupling& coupling,
                          std::span<const std::uint8_t> held, std::span<const Vec3> rhs,
                          std::span<Vec3> x) {
    if (std::ranges::any_of(held, [](std::uint8_t h) { return h != 0; })) return;
    const auto apply = [&](const std::vector<Vec3>& d, std::vector<Vec3>& product) {
        multiply(matrix, d, product);
        if (coupling) coupling(d, product);
    };
    std::vector<Vec3> field(x.begin(), x.end()), product;
    apply(field, product);
    const Vec3 left = sum_of(rhs) - sum_of(product);
    Mat3 common;
    for (int c = 0; c < 3; ++c) {
        std::ranges::fill(field, Vec3::Unit(c));
        apply(field, product);
        common.col(c) = sum_of(product);
    }
    const Vec3 shift = common.inverse() * left;
    if (!shift.allFinite()) return;
    for (Vec3& value : x) value += shift;
}

SolveReport solve_coupled(LinearSolver& solver, const BlockMatrix& matrix, const Coupling& coupling,
                          std::span<const std::uint8_t> held, std::span<const Vec3> rhs,
                          std::span<Vec3> x, const SolveLimits& limits,
                          const std::stop_token& stop) {
    const auto apply = [&](const std::vector<Vec3>& d, std::vector<Vec3>& product) {
        multiply(matrix, d, product);
        coupling(d, product);
    };
    const auto precondition = [&](const std::vector<Vec3>& r, std::vector<Vec3>& z) {
        solver.precondition(r, z);
    };
    ConjugateGradient iteration;
    SolveReport report = iteration.solve(apply, precondition, rhs, x, limits, stop);
    report.method = "coupled";
    keep_sum_of_residual(matrix, coupling, held, rhs, x);
    return report;
}

}  // namespace hepatica
