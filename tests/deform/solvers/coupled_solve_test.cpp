// SPDX-License-Identifier: GPL-3.0-or-later
// Two bars tied by springs that have no block in the matrix, against a dense factorisation of all.
#include "core/deform/solvers/coupled_solve.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "core/deform/potentials/pair_stiffness.h"
#include "core/deform/solvers/node_loops.h"
#include "core/deform/step/assembly.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

TEST(CoupledSolve, IsThatOfTheWholeMatrixAndKeepsTheSumOfTheResidual) {
    const Body body =
        build_body(test::crossed_bars(1.0), ElementModel::corotated, ElementOrder::linear);
    const int nodes = body.node_count(), half = nodes / 2;
    Assembly assembly(body);
    assembly.evaluate(body.rest_positions_mm);
    BlockMatrix matrix;
    assembly.gather_stiffness(1.0 / 3600.0, matrix);
    for (int i = 0; i < nodes; ++i)
        matrix.block[matrix.diagonal[i]].diagonal().array() += body.mass_g[i];
    // Springs between single nodes, up to far stiffer than the body.
    std::vector<std::pair<PointPair, Mat3>> springs;
    for (int k = 0; k < 20; ++k) {
        const int a = 5 * k, b = half + 4 * k;
        springs.push_back(
            {{{a, b, b, b}, {1.0, -1.0, 0.0, 0.0}, 1},
             std::pow(10.0, k % 5) * Vec3(0.1 * k, 1, 2) * Vec3(0.1 * k, 1, 2).transpose()});
    }
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
    for (int i = 0; i < nodes; ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k)
            dense.block<3, 3>(3 * i, 3 * matrix.column[k]) = matrix.block[k];
    for (const auto& [pair, k] : springs) {
        const int a = pair.nodes[0], b = pair.nodes[1];
        dense.block<3, 3>(3 * a, 3 * a) += k;
        dense.block<3, 3>(3 * b, 3 * b) += k;
        dense.block<3, 3>(3 * a, 3 * b) -= k;
        dense.block<3, 3>(3 * b, 3 * a) -= k;
        add_within(pair, k, {}, matrix);
    }
    const auto rhs = test::random_field(nodes, 1.0, 7);
    Eigen::VectorXd b(3 * nodes);
    for (int i = 0; i < nodes; ++i) b.segment<3>(3 * i) = rhs[i];
    const Eigen::VectorXd exact = dense.llt().solve(b);
    const Coupling coupling = [&](std::span<const Vec3> d, std::span<Vec3> product) {
        for (const auto& [pair, k] : springs) add_pair_product(pair, k, false, {}, d, product);
    };
    const std::vector<std::uint8_t> held(nodes, 0);
    for (const LinearSolverKind kind :
         {LinearSolverKind::block_jacobi, LinearSolverKind::cholesky}) {
        const auto solver = make_linear_solver(kind, {}, body.rest_positions_mm);
        solver->prepare(matrix, body.rest_positions_mm);
        for (const double tolerance : {1e-2, 1e-6}) {
            std::vector<Vec3> x(nodes, Vec3::Zero());
            const SolveReport report = solve_coupled(*solver, matrix, coupling, held, rhs, x,
                                                     {.energy_tolerance = tolerance});
            EXPECT_TRUE(report.converged);
            EXPECT_GT(report.iterations, 0);
            Eigen::VectorXd error = exact;
            for (int i = 0; i < nodes; ++i) error.segment<3>(3 * i) -= x[i];
            EXPECT_LT(std::sqrt(error.dot(dense * error) / exact.dot(dense * exact)), tolerance);
            Vec3 left = Vec3::Zero(), size = Vec3::Zero();
            const Eigen::VectorXd residual = dense * error;
            for (int i = 0; i < nodes; ++i) {
                left += residual.segment<3>(3 * i);
                size += rhs[i].cwiseAbs();
            }
            EXPECT_LT(left.norm(), 1e-10 * size.norm());
        }
    }
}

}  // namespace
}  // namespace hepatica
