// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/skeleton_preconditioner.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <random>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/deform/solvers/node_loops.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

using test::SampleBody;

struct Case {
    SampleBody body;
    std::vector<Vec3> positions;
    BlockMatrix matrix;
    std::vector<Vec3> load;
};

Case make_case(SampleBody body, double bend_rad, double length_mm) {
    Case result;
    result.body = std::move(body);
    result.positions = test::bend(result.body.mesh.vertices_mm, bend_rad, length_mm);
    result.matrix = test::assemble(result.body, result.positions, {});
    result.load = test::make_load(result.body, {});
    return result;
}

Case bent_bar(int diameters, int cells_across, double bend_rad) {
    const double length = 6.0 * diameters;
    return make_case(test::make_bar(length, 6.0, diameters * cells_across, cells_across), bend_rad,
                     length);
}

std::vector<Vec3> random_vectors(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Vec3> values(count);
    for (Vec3& value : values) {
        for (int a = 0; a < 3; ++a) value[a] = static_cast<double>(random()) / 2147483648.0 - 1.0;
    }
    return values;
}

Eigen::MatrixXd dense(const BlockMatrix& matrix) {
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(3 * matrix.rows(), 3 * matrix.rows());
    for (int i = 0; i < matrix.rows(); ++i) {
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k) {
            full.block<3, 3>(3 * i, 3 * matrix.column[k]) = matrix.block[k];
        }
    }
    return full;
}

TEST(AffineCoarseSpace, ReproducesAffineMotionExactly) {
    const Case tree = make_case(test::make_brick_tree(4, 3.0, 1.2), 0.4, 90.0);
    AffineCoarseSpace space(tree.body.skeleton,
                            bind_vertices(tree.body.skeleton, tree.body.mesh.vertices_mm),
                            tree.matrix);
    space.set_shape(tree.positions, std::vector<char>(tree.positions.size(), 0));
    Mat3 gradient;
    gradient << 0.3, -1.0, 0.2, 0.7, 0.1, 2.0, -0.4, 0.0, 0.5;
    const Vec3 shift(3.0, -2.0, 1.0);
    std::vector<Vec3> coarse;
    for (int n = 0; n < space.node_count(); ++n) {
        coarse.push_back(gradient * space.centres_mm()[n] + shift);
        for (int a = 0; a < 3; ++a) {
            coarse.push_back(tree.body.skeleton.radii_mm[n] * gradient.col(a));
        }
    }
    std::vector<Vec3> motion(tree.positions.size(), Vec3::Zero());
    space.add_motion(coarse, motion);
    for (std::size_t v = 0; v < motion.size(); ++v) {
        EXPECT_LT((motion[v] - gradient * tree.positions[v] - shift).norm(), 1e-11);
    }
}

TEST(AffineCoarseSpace, ProjectsTheMatrixAndItsVectors) {
    const Case tree = make_case(test::make_brick_tree(3, 3.0, 1.4), 0.4, 90.0);
    AffineCoarseSpace space(tree.body.skeleton,
                            bind_vertices(tree.body.skeleton, tree.body.mesh.vertices_mm),
                            tree.matrix);
    space.set_shape(tree.positions, lone_vertices(tree.matrix));
    const std::size_t vectors = static_cast<std::size_t>(vectors_per_node * space.node_count());
    BlockMatrix coarse = space.coarse_pattern();
    space.project(tree.matrix, coarse);
    for (unsigned seed = 1; seed < 4; ++seed) {
        const std::vector<Vec3> a = random_vectors(vectors, seed);
        std::vector<Vec3> fine(tree.positions.size(), Vec3::Zero()), product, projected, direct;
        space.add_motion(a, fine);
        multiply(tree.matrix, fine, product);
        space.restrict_to_nodes(product, projected);
        multiply(coarse, a, direct);
        double difference = 0.0, scale = 0.0;
        for (std::size_t i = 0; i < vectors; ++i) {
            difference += (projected[i] - direct[i]).squaredNorm();
            scale += direct[i].squaredNorm();
        }
        EXPECT_LT(std::sqrt(difference / scale), 1e-12);
        const std::vector<Vec3> b = random_vectors(tree.positions.size(), seed);
        std::vector<Vec3> restricted;
        space.restrict_to_nodes(b, restricted);
        EXPECT_NEAR(dot(restricted, a), dot(b, fine),
                    1e-9 * std::sqrt(dot(b, b) * dot(fine, fine)));
    }
}

TEST(SkeletonPreconditioner, CoarseEliminationHasNextToNoFillAndSolvesLikeADenseOne) {
    const Case tree = make_case(test::make_brick_tree(4, 3.0, 1.2), 0.4, 90.0);
    SkeletonPreconditioner preconditioner(tree.body.skeleton, tree.body.mesh.vertices_mm);
    preconditioner.prepare(tree.matrix, tree.positions);
    const BlockMatrix& pattern = preconditioner.space().coarse_pattern();
    // Padding of small supernodes to dense fronts is all that is added to the lower triangle.
    const std::size_t lower =
        (pattern.column.size() + static_cast<std::size_t>(pattern.rows())) / 2;
    EXPECT_LT(preconditioner.coarse_factor().tree().factor_blocks, lower * 5 / 4);

    BlockMatrix coarse = pattern;
    preconditioner.space().project(tree.matrix, coarse);
    std::vector<int> order;
    for (int i = 0; i < coarse.rows(); ++i) order.push_back(i);
    TreeCholesky factor(coarse, order);
    factor.factor(coarse);
    const std::vector<Vec3> b = random_vectors(order.size(), 5);
    std::vector<Vec3> x(b.size());
    factor.solve(b, x);
    Eigen::VectorXd rhs(3 * coarse.rows());
    for (int i = 0; i < coarse.rows(); ++i) rhs.segment<3>(3 * i) = b[i];
    // Nodes at fixed vertices may leave the matrix semidefinite: compare what A does to x.
    const Eigen::MatrixXd full = dense(coarse);
    Eigen::VectorXd solution(rhs.size());
    for (int i = 0; i < coarse.rows(); ++i) solution.segment<3>(3 * i) = x[i];
    const Eigen::VectorXd oracle = Eigen::LDLT<Eigen::MatrixXd>(full).solve(rhs);
    const Eigen::VectorXd difference = solution - oracle;
    EXPECT_LT(std::sqrt(std::abs(difference.dot(full * difference))),
              1e-6 * std::sqrt(std::abs(oracle.dot(full * oracle))));
}

TEST(SkeletonPreconditioner, IsSymmetricAndPositive) {
    const Case tree = make_case(test::make_brick_tree(3, 3.0, 1.2), 0.4, 90.0);
    SkeletonPreconditioner preconditioner(tree.body.skeleton, tree.body.mesh.vertices_mm);
    preconditioner.prepare(tree.matrix, tree.positions);
    for (unsigned seed = 1; seed < 6; ++seed) {
        const std::vector<Vec3> a = random_vectors(tree.positions.size(), 2 * seed);
        const std::vector<Vec3> b = random_vectors(tree.positions.size(), 2 * seed + 1);
        std::vector<Vec3> applied_a, applied_b;
        preconditioner.apply(a, applied_a);
        preconditioner.apply(b, applied_b);
        const double scale = std::sqrt(dot(a, applied_a) * dot(b, applied_b));
        EXPECT_GT(dot(a, applied_a), 0.0);
        EXPECT_NEAR(dot(b, applied_a), dot(a, applied_b), 1e-9 * scale);
    }
}

TEST(SkeletonSolver, IterationsDoNotGrowWithLengthAndTheEstimateHolds) {
    int shortest = 0;
    for (const int diameters : {10, 30, 100, 300}) {
        for (const double bend_rad : {0.01, 2.5}) {
            const Case bar = bent_bar(diameters, 2, bend_rad);
            SkeletonSolver solver(bar.body.skeleton, bar.body.mesh.vertices_mm);
            solver.prepare(bar.matrix, bar.positions);
            std::vector<Vec3> x(bar.load.size(), Vec3::Zero());
            const SolveReport report = solver.solve(bar.load, x, {.energy_tolerance = 1e-2});
            const double error =
                test::energy_error(bar.matrix, x, test::solve_exactly(bar.matrix, bar.load));
            EXPECT_TRUE(report.converged);
            EXPECT_LE(error, report.energy_error);
            EXPECT_LE(report.energy_error, 1e-2);
            EXPECT_LE(report.iterations, 15) << diameters;
            if (diameters == 10) shortest = std::max(shortest, report.iterations);
            EXPECT_LE(report.iterations, 1.3 * shortest) << diameters;
        }
    }
}

TEST(SkeletonSolver, BranchingTreeRefinedTwice) {
    for (const double cell : {1.6, 1.0}) {
        const Case tree = make_case(test::make_brick_tree(5, 4.0, cell), 0.5, 110.0);
        SkeletonSolver solver(tree.body.skeleton, tree.body.mesh.vertices_mm);
        solver.prepare(tree.matrix, tree.positions);
        const std::vector<Vec3> exact = test::solve_exactly(tree.matrix, tree.load);
        for (int repetition = 0; repetition < 2; ++repetition) {
            std::vector<Vec3> x(tree.load.size(), Vec3::Zero());
            const SolveReport report = solver.solve(tree.load, x, {.energy_tolerance = 1e-2});
            const double error = test::energy_error(tree.matrix, x, exact);
            EXPECT_TRUE(report.converged);
            EXPECT_LE(error, report.energy_error);
            EXPECT_GE(error, 0.2 * report.energy_error);
            EXPECT_LE(report.iterations, 15) << cell;
        }
    }
}

TEST(SkeletonSolver, DegenerateSkeletonsStillSolve) {
    const Case bar = bent_bar(6, 2, 0.5);
    const std::vector<Vec3> exact = test::solve_exactly(bar.matrix, bar.load);
    CoarseSkeleton one, crowded, far, collinear;
    one = {{Vec3(18, 0, 0)}, {-1}, {3.0}};
    far = {{Vec3(1e5, 0, 0), Vec3(1e5, 10, 0)}, {-1, 0}, {3.0, 3.0}};
    for (int n = 0; n < 200; ++n) {  // more nodes than vertices, many of them without any
        crowded.positions_mm.emplace_back(0.18 * n, 0.0, 0.0);
        crowded.parent.push_back(n - 1);
        crowded.radii_mm.push_back(3.0);
    }
    for (int n = 0; n < 5; ++n) {  // all in one place
        collinear.positions_mm.emplace_back(0.0, 0.0, 0.0);
        collinear.parent.push_back(n == 3 ? -1 : n - 1);
        collinear.radii_mm.push_back(1e-6);
    }
    for (const CoarseSkeleton& skeleton : {one, crowded, far, collinear}) {
        SkeletonSolver solver(skeleton, bar.body.mesh.vertices_mm);
        solver.prepare(bar.matrix, bar.positions);
        std::vector<Vec3> x(bar.load.size(), Vec3::Zero());
        const SolveReport report = solver.solve(bar.load, x, {.energy_tolerance = 1e-3});
        EXPECT_TRUE(report.converged);
        EXPECT_LT(test::energy_error(bar.matrix, x, exact), 1e-3);
    }
    EXPECT_THROW(SkeletonSolver({}, bar.body.mesh.vertices_mm), InputError);
}

TEST(SkeletonSolver, ASkeletonFromTheMeshServesAsWell) {
    const Case bar = bent_bar(40, 3, 1.0);
    SkeletonSolver solver(skeleton_of_mesh(bar.body.mesh), bar.body.mesh.vertices_mm);
    solver.prepare(bar.matrix, bar.positions);
    std::vector<Vec3> x(bar.load.size(), Vec3::Zero());
    const SolveReport report = solver.solve(bar.load, x, {.energy_tolerance = 1e-2});
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.iterations, 25);
}

TEST(SkeletonSolver, KeepsTheErrorWhileTheBodyTurnsUnderAnOldPreconditioner) {
    const SampleBody body = test::make_bar(120.0, 6.0, 60, 3);
    SkeletonSolver lagging(body.skeleton, body.mesh.vertices_mm);
    SkeletonSolver fresh(body.skeleton, body.mesh.vertices_mm, {.always_fresh = true});
    int more = 0;
    for (int frame = 0; frame < 20; ++frame) {
        // Turns a little more in every frame, and jumps half-way.
        const Case bar = make_case(body, 0.02 * frame + (frame < 10 ? 0.01 : 2.0), 120.0);
        const std::vector<Vec3> exact = test::solve_exactly(bar.matrix, bar.load);
        for (SkeletonSolver* solver : {&lagging, &fresh}) {
            solver->prepare(bar.matrix, bar.positions);
            std::vector<Vec3> x(bar.load.size(), Vec3::Zero());
            const SolveReport report = solver->solve(bar.load, x, {.energy_tolerance = 1e-2});
            EXPECT_TRUE(report.converged);
            EXPECT_LE(test::energy_error(bar.matrix, x, exact), 1e-2);
            more += solver == &lagging ? report.iterations : -report.iterations;
        }
    }
    EXPECT_LE(more, 3 * 20);  // no more than preparing every time would have cost
}

SolveReport solve_that_took(int iterations, bool converged) {
    SolveReport report;
    report.iterations = iterations;
    report.converged = converged;
    return report;
}

// Couplings are solved around it: as long as they take about as many iterations as a fresh solve it
// is kept, then it is made anew at the next matrix. A restored one knows that, too.
TEST(SkeletonSolver, IsMadeAnewAfterASolveThatOnlyPreconditionedByItAndTookLong) {
    const Case bar = bent_bar(10, 2, 0.5), further = bent_bar(10, 2, 0.52);
    SkeletonSolver solver(bar.body.skeleton, bar.body.mesh.vertices_mm);
    solver.prepare(bar.matrix, bar.positions);
    std::vector<Vec3> x(bar.load.size(), Vec3::Zero());
    const int fresh = solver.solve(bar.load, x, {}).iterations;
    const auto made_anew_after = [&](int iterations, bool converged) {
        solver.prepare(further.matrix, further.positions);
        EXPECT_FALSE(solver.made_from_latest());
        solver.wear(solve_that_took(iterations, converged));
        SkeletonSolver restored(bar.body.skeleton, bar.body.mesh.vertices_mm);
        restored.restore(further.matrix, true, further.positions, solver.memory());
        for (SkeletonSolver* each : {&solver, &restored}) each->prepare(bar.matrix, bar.positions);
        EXPECT_EQ(restored.made_from_latest(), solver.made_from_latest());
        return solver.made_from_latest();
    };
    EXPECT_FALSE(made_anew_after(fresh + 1, true));
    EXPECT_TRUE(made_anew_after(fresh + 200, true));
    EXPECT_FALSE(made_anew_after(fresh + 1, true));
    EXPECT_TRUE(made_anew_after(1, false));
}

// Every second vertex is so much stiffer that the kept preconditioner serves no longer, and that
// one of its own takes more iterations, too.
BlockMatrix stiffer_at_every_second(BlockMatrix matrix) {
    const auto scale = [](int vertex) { return vertex % 2 == 0 ? 1.0 : 30.0; };
    for (int i = 0; i < matrix.rows(); ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k)
            matrix.block[k] *= scale(i) * scale(matrix.column[k]);
    return matrix;
}

// A solve that was interrupted to prepare anew says nothing of how many iterations a whole one
// takes: the next one is counted. Then the preconditioner is kept again.
TEST(SkeletonSolver, CountsAnewWhereABodyHasBecomeHarder) {
    const Case bar = bent_bar(10, 2, 0.5);
    const BlockMatrix harder = stiffer_at_every_second(bar.matrix);
    SkeletonSolver solver(bar.body.skeleton, bar.body.mesh.vertices_mm);
    const auto iterations = [&](const BlockMatrix& matrix) {
        solver.prepare(matrix, bar.positions);
        std::vector<Vec3> x(bar.load.size(), Vec3::Zero());
        const SolveReport report = solver.solve(bar.load, x, {});
        EXPECT_TRUE(report.converged);
        return report.iterations;
    };
    const int easy = iterations(bar.matrix);
    iterations(harder);
    ASSERT_TRUE(solver.made_from_latest()) << "it was not interrupted";
    const int counted = iterations(harder);
    EXPECT_TRUE(solver.made_from_latest());
    ASSERT_GT(counted, easy + 10);
    for (int again = 0; again < 3; ++again) {
        EXPECT_LE(iterations(harder), counted + 3);
        EXPECT_FALSE(solver.made_from_latest()) << again;
    }
}

TEST(AutomaticSolver, PassesOnThatItsPreconditionerIsWorn) {
    const Case bulky = make_case(test::make_bar(60.0, 36.0, 15, 9), 0.1, 60.0);
    const auto solver = make_linear_solver(LinearSolverKind::automatic, bulky.body.skeleton,
                                           bulky.body.mesh.vertices_mm);
    solver->prepare(bulky.matrix, bulky.positions);
    solver->prepare(bulky.matrix, bulky.positions);
    EXPECT_FALSE(solver->made_from_latest());
    solver->wear(solve_that_took(500, true));
    solver->prepare(bulky.matrix, bulky.positions);
    EXPECT_TRUE(solver->made_from_latest());
}

TEST(SkeletonSolver, RecoversFromAMatrixThatIsNotFinite) {
    const Case bar = bent_bar(10, 2, 0.5);
    BlockMatrix bad = bar.matrix;
    for (Mat3& block : bad.block) block *= std::numeric_limits<double>::quiet_NaN();
    SkeletonSolver solver(bar.body.skeleton, bar.body.mesh.vertices_mm);
    std::vector<Vec3> x(bar.load.size());
    for (const bool broken : {true, false, true, false}) {
        solver.prepare(broken ? bad : bar.matrix, bar.positions);
        std::fill(x.begin(), x.end(), Vec3::Zero());
        EXPECT_EQ(solver.solve(bar.load, x, {}).converged, !broken);
        for (const Vec3& value : x) EXPECT_TRUE(value.allFinite());
    }
    EXPECT_LT(test::energy_error(bar.matrix, x, test::solve_exactly(bar.matrix, bar.load)), 1e-2);
}

TEST(SkeletonSolver, SameBitsForAnyNumberOfThreads) {
    const Case tree = make_case(test::make_brick_tree(4, 3.0, 1.0), 0.4, 90.0);
    std::vector<std::vector<Vec3>> results;
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        SkeletonSolver solver(tree.body.skeleton, tree.body.mesh.vertices_mm);
        solver.prepare(tree.matrix, tree.positions);
        results.emplace_back(tree.load.size(), Vec3::Zero());
        solver.solve(tree.load, results.back(), {.energy_tolerance = 1e-3});
    }
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(results[0], results[2]);
}

TEST(SkeletonSolver, EverythingFixedIsSolvedAtOnce) {
    SampleBody body = test::make_bar(12.0, 6.0, 4, 2);
    std::fill(body.fixed.begin(), body.fixed.end(), 1);
    const BlockMatrix matrix = test::assemble(body, body.mesh.vertices_mm, {});
    SkeletonSolver solver(body.skeleton, body.mesh.vertices_mm);
    solver.prepare(matrix, body.mesh.vertices_mm);
    const std::vector<Vec3> load = random_vectors(body.mesh.vertices_mm.size(), 1);
    std::vector<Vec3> x(load.size(), Vec3::Zero());
    EXPECT_TRUE(solver.solve(load, x, {.energy_tolerance = 1e-10}).converged);
    EXPECT_LT(test::energy_error(matrix, x, test::solve_exactly(matrix, load)), 1e-10);
}

}  // namespace
}  // namespace hepatica
