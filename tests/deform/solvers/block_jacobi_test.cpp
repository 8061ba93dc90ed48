// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/block_jacobi.h"

#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

using test::SampleBody;
using test::SampleMaterial;

struct System {
    BlockMatrix matrix;
    std::vector<Vec3> positions, load, exact;
};

System bar_system(int cells_along) {
    const SampleBody body = test::make_bar(1.5 * cells_along, 6.0, cells_along, 3);
    const SampleMaterial material;
    System system;
    system.positions = test::bend(body.mesh.vertices_mm, 1.5, 1.5 * cells_along);
    system.matrix = test::assemble(body, system.positions, material);
    system.load = test::make_load(body, material);
    system.exact = test::solve_exactly(system.matrix, system.load);
    return system;
}

TEST(BlockMatrix, MultiplyIsSymmetricAndFindsItsBlocks) {
    const System system = bar_system(6);
    std::vector<Vec3> a(system.load.size()), b(system.load.size()), product_a, product_b;
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = Vec3::Random();
        b[i] = Vec3::Random();
    }
    multiply(system.matrix, a, product_a);
    multiply(system.matrix, b, product_b);
    double ab = 0.0, ba = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += b[i].dot(product_a[i]);
        ba += a[i].dot(product_b[i]);
    }
    EXPECT_NEAR(ab, ba, 1e-10 * std::abs(ab));
    for (int i = 0; i < system.matrix.rows(); ++i) {
        EXPECT_EQ(system.matrix.find(i, i), system.matrix.diagonal[i]);
    }
    EXPECT_EQ(system.matrix.find(0, system.matrix.rows() - 1), -1);
}

TEST(BlockJacobi, ReachesTheExactSolutionAndSaysHowClose) {
    const System system = bar_system(10);
    const auto solver = make_block_jacobi_solver();
    solver->prepare(system.matrix, system.positions);
    for (const double tolerance : {1e-1, 1e-2, 1e-4}) {
        std::vector<Vec3> x(system.load.size(), Vec3::Zero());
        const SolveReport report = solver->solve(system.load, x, {.energy_tolerance = tolerance});
        const double error = test::energy_error(system.matrix, x, system.exact);
        EXPECT_TRUE(report.converged);
        EXPECT_LE(error, 1.02 * tolerance);
        EXPECT_GE(report.energy_error, 0.98 * error) << "at " << tolerance;
    }
}

TEST(BlockJacobi, StoppedEarlyItOwnsUpToItsError) {
    const System system = bar_system(40);
    for (const int iterations : {5, 20, 60, 150, 300}) {
        const auto solver = make_block_jacobi_solver();
        solver->prepare(system.matrix, system.positions);
        std::vector<Vec3> x(system.load.size(), Vec3::Zero());
        const SolveReport report =
            solver->solve(system.load, x, {.energy_tolerance = 1e-2, .max_iterations = iterations});
        const double error = test::energy_error(system.matrix, x, system.exact);
        RecordProperty("error_" + std::to_string(iterations), std::to_string(error));
        EXPECT_GE(report.energy_error, 0.8 * error) << iterations << " iterations";
        EXPECT_EQ(report.converged, report.iterations < iterations);
    }
}

TEST(BlockJacobi, WarmStartIsNeverWorseThanNone) {
    const System system = bar_system(10);
    const auto solver = make_block_jacobi_solver();
    solver->prepare(system.matrix, system.positions);
    std::vector<Vec3> warm;
    for (const Vec3& x : system.exact) warm.push_back(1e4 * x);
    const SolveReport report = solver->solve(system.load, warm, {.energy_tolerance = 1e-3});
    EXPECT_LT(report.iterations, 10);
    EXPECT_LT(test::energy_error(system.matrix, warm, system.exact), 1e-3);
}

TEST(BlockJacobi, ZeroLoadGivesZero) {
    const System system = bar_system(4);
    const auto solver = make_block_jacobi_solver();
    solver->prepare(system.matrix, system.positions);
    std::vector<Vec3> x(system.load.size(), Vec3::Ones());
    const std::vector<Vec3> nothing(system.load.size(), Vec3::Zero());
    EXPECT_TRUE(solver->solve(nothing, x, {}).converged);
    for (const Vec3& value : x) EXPECT_EQ(value, Vec3::Zero());
}

TEST(BlockJacobi, SameBitsForAnyNumberOfThreads) {
    const System system = bar_system(200);
    std::vector<std::vector<Vec3>> results;
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        const auto solver = make_block_jacobi_solver();
        solver->prepare(system.matrix, system.positions);
        results.emplace_back(system.load.size(), Vec3::Zero());
        solver->solve(system.load, results.back(), {.max_iterations = 40});
    }
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(results[0], results[2]);
}

}  // namespace
}  // namespace hepatica
