// SPDX-License-Identifier: GPL-3.0-or-later
// The staged coarse solve against a dense factorisation, and its depth.
#include "gpu/step/coarse_program.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/deform/solvers/affine_coarse_space.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

using gpu::CoarseProgram;

Eigen::MatrixXd dense(const BlockMatrix& matrix) {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(3 * matrix.rows(), 3 * matrix.rows());
    for (int i = 0; i < matrix.rows(); ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k)
            all.block<3, 3>(3 * i, 3 * matrix.column[k]) = matrix.block[k];
    return all;
}

Eigen::VectorXd run(const CoarseProgram& program, const Eigen::VectorXd& load) {
    std::vector<double> value(static_cast<std::size_t>(program.values), 0.0);
    std::copy(load.begin(), load.end(), value.begin());
    for (std::size_t s = 0; s + 1 < program.stage_begin.size(); ++s) {
        std::vector<double> written = value;  // a stage reads nothing that it writes
        for (int row = program.stage_begin[s]; row < program.stage_begin[s + 1]; ++row) {
            double sum = 0.0;
            for (int k = program.begin[row]; k < program.begin[row + 1]; ++k)
                sum += program.factor[k] * value[program.source[k]];
            written[program.target[row]] = sum;
        }
        value = std::move(written);
    }
    return Eigen::Map<Eigen::VectorXd>(value.data() + program.solution, load.size());
}

CoarseSkeleton chain(int nodes) {
    CoarseSkeleton skeleton;
    for (int i = 0; i < nodes; ++i) {
        skeleton.positions_mm.push_back({2.0 * i, 0.0, 0.0});
        skeleton.parent.push_back(i - 1);
        skeleton.radii_mm.push_back(2.0);
    }
    return skeleton;
}

TEST(CoarseProgram, SolvesWhatADenseFactorSolves) {
    const test::SampleBody body = test::make_brick_tree(3, 4.0, 2.0);
    const BlockMatrix matrix = test::assemble(body, body.mesh.vertices_mm, {});
    AffineCoarseSpace space(body.skeleton, bind_vertices(body.skeleton, body.mesh.vertices_mm),
                            matrix);
    space.set_shape(body.mesh.vertices_mm, body.fixed);
    BlockMatrix coarse = space.coarse_pattern();
    space.project(matrix, coarse);
    Eigen::MatrixXd exact = dense(coarse);
    // A node that moves no vertex answers nothing.
    for (int i = 0; i < exact.rows(); ++i)
        if (!(exact(i, i) > 0.0)) exact(i, i) = 1.0;
    const Eigen::VectorXd answer = Eigen::VectorXd::LinSpaced(exact.rows(), -1.0, 2.0);
    const CoarseProgram program = gpu::program_of(coarse, gpu::bisecting_order(body.skeleton));
    const Eigen::VectorXd error = run(program, exact * answer) - answer;
    EXPECT_LT(std::sqrt(error.dot(exact * error) / answer.dot(exact * answer)), 1e-4);
}

TEST(BisectingOrder, NamesEveryNodeOnce) {
    for (const CoarseSkeleton& skeleton :
         {chain(1), chain(2), chain(57), test::make_brick_tree(4, 4.0, 2.0).skeleton}) {
        std::vector<int> order = gpu::bisecting_order(skeleton), all(order.size());
        ASSERT_EQ(static_cast<int>(order.size()), skeleton.size());
        std::iota(all.begin(), all.end(), 0);
        std::ranges::sort(order);
        EXPECT_EQ(order, all);
    }
}

// Nodes that share elements with the next two on either side, as in a vessel.
TEST(BisectingOrder, MakesLongChainsShallow) {
    const int nodes = 400;
    BlockMatrix coarse;
    for (int i = 0; i < 4 * nodes; ++i) {
        for (int j = 0; j < 4 * nodes; ++j) {
            if (std::abs(i / 4 - j / 4) > 2) continue;
            if (i == j) coarse.diagonal.push_back(static_cast<int>(coarse.column.size()));
            coarse.column.push_back(j);
            coarse.block.push_back(i == j ? Mat3(100.0 * Mat3::Identity())
                                          : Mat3(Mat3::Identity()));
        }
        coarse.row_begin.push_back(static_cast<int>(coarse.column.size()));
    }
    const CoarseProgram program = gpu::program_of(coarse, gpu::bisecting_order(chain(nodes)));
    EXPECT_LT(program.stage_begin.size(), 120u);  // 1600 from one end to the other
}

}  // namespace
}  // namespace hepatica
