// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/cholesky_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/deform/solvers/automatic_solver.h"
#include "core/deform/solvers/node_loops.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

using test::SampleBody;

// A bar whose far part turns a little more in every frame.
struct Motion {
    SampleBody body = test::make_bar(120.0, 6.0, 60, 3);

    std::vector<Vec3> positions(double bend_rad, double from_mm) const {
        std::vector<Vec3> moved = body.mesh.vertices_mm;
        std::vector<Vec3> tail;
        for (const Vec3& x : moved) tail.push_back(x - Vec3(from_mm, 0, 0));
        const std::vector<Vec3> bent = test::bend(tail, bend_rad, 120.0 - from_mm);
        for (std::size_t v = 0; v < moved.size(); ++v) {
            if (tail[v].x() > 0.0) moved[v] = bent[v] + Vec3(from_mm, 0, 0);
        }
        return moved;
    }
};

TEST(CholeskySolver, SolvesDirectlyAndReportsItsError) {
    const Motion motion;
    const auto positions = motion.positions(1.0, 0.0);
    const BlockMatrix matrix = test::assemble(motion.body, positions, {});
    CholeskySolver solver;
    solver.prepare(matrix, positions);
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    std::vector<Vec3> x(load.size(), Vec3::Zero());
    const SolveReport report = solver.solve(load, x, {});
    EXPECT_EQ(report.iterations, 0);
    EXPECT_TRUE(report.converged);
    EXPECT_TRUE(solver.in_single_precision());
    EXPECT_EQ(report.method, "cholesky");
    const double error = test::energy_error(matrix, x, test::solve_exactly(matrix, load));
    EXPECT_LT(error, 1e-2);
    EXPECT_NEAR(report.energy_error, error, 0.1 * error);
}

// The matrix is at least the body's mass. Where that is too weak a bound the error is estimated.
TEST(CholeskySolver, TellsByABoundThatTheErrorIsSmallEnough) {
    const Motion motion;
    const auto positions = motion.positions(1.0, 0.0);
    const BlockMatrix matrix = test::assemble(motion.body, positions, {});
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    const std::vector<double> mass_g = test::vertex_masses(motion.body, {});
    const auto solved = [&](std::span<const double> least, double tolerance, std::vector<Vec3>& x) {
        CholeskySolver solver;
        solver.bound_below(least, 1.0);
        solver.prepare(matrix, positions);
        x.assign(load.size(), Vec3::Zero());
        return solver.solve(load, x, {.energy_tolerance = tolerance});
    };
    std::vector<Vec3> x, same;
    const double estimate = solved({}, 1e-2, x).energy_error;
    const double error = test::energy_error(matrix, x, test::solve_exactly(matrix, load));
    const SolveReport bounded = solved(mass_g, 1.0, same);
    EXPECT_EQ(same, x);
    EXPECT_TRUE(bounded.converged);
    EXPECT_GT(bounded.energy_error, 2.0 * error) << "not the estimate";
    EXPECT_LE(bounded.energy_error, 1.0);
    const double between = std::sqrt(bounded.energy_error * error);
    const SolveReport estimated = solved(mass_g, between, same);
    EXPECT_EQ(estimated.energy_error, estimate);
    EXPECT_EQ(estimated.iterations, 0);
}

// Residuals are taken in double: iterations with the factor reach what its precision does not.
TEST(CholeskySolver, PolishesToAnyTolerance) {
    const Motion motion;
    const auto positions = motion.positions(1.0, 0.0);
    const BlockMatrix matrix = test::assemble(motion.body, positions, {});
    CholeskySolver solver;
    solver.prepare(matrix, positions);
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    std::vector<Vec3> x(load.size(), Vec3::Zero());
    const SolveReport report = solver.solve(load, x, {.energy_tolerance = 1e-10});
    EXPECT_TRUE(report.converged);
    EXPECT_GT(report.iterations, 0);
    EXPECT_LE(report.iterations, 6);
    EXPECT_TRUE(solver.in_single_precision());
    EXPECT_LT(test::energy_error(matrix, x, test::solve_exactly(matrix, load)), 1e-8);
}

// For who needs it beside the answer: not another product. Iterations do not come by it.
TEST(CholeskySolver, KnowsTheProductOfADirectAnswer) {
    const Motion motion;
    const auto positions = motion.positions(1.0, 0.0);
    const BlockMatrix matrix = test::assemble(motion.body, positions, {});
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    CholeskySolver solver;
    EXPECT_EQ(solver.product(), nullptr);
    solver.prepare(matrix, positions);
    std::vector<Vec3> x(load.size(), Vec3::Zero()), expected;
    solver.solve(load, x, {});
    multiply(matrix, x, expected);
    ASSERT_NE(solver.product(), nullptr);
    EXPECT_EQ(*solver.product(), expected);
    solver.prepare(matrix, positions);
    EXPECT_EQ(solver.product(), nullptr) << "of the matrix before";
    solver.solve(load, x, {});
    solver.solve(load, x, {.energy_tolerance = 1e-10});
    EXPECT_EQ(solver.product(), nullptr) << "of an answer that was improved since";
}

// One end is a million million times as stiff as the other: single precision loses the soft one.
TEST(CholeskySolver, GoesOverToDoublePrecisionWhereSingleDoesNotDo) {
    const Motion motion;
    const std::vector<Vec3>& rest = motion.body.mesh.vertices_mm;
    BlockMatrix matrix = test::assemble(motion.body, rest, {});
    for (int i = 0; i < matrix.rows(); ++i)
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k)
            matrix.block[k] *= std::exp(0.115 * (rest[i].x() + rest[matrix.column[k]].x()));
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    std::vector<Vec3> x(load.size(), Vec3::Zero());
    CholeskySolver solver;
    solver.prepare(matrix, rest);
    const SolveReport report = solver.solve(load, x, {.energy_tolerance = 1e-6});
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.dropped_pivots, 0);
    EXPECT_LT(test::energy_error(matrix, x, test::solve_exactly(matrix, load)), 1e-5);
}

// The rows that are named and those between them and the root, to the bits of a new factor.
TEST(CholeskySolver, FactorsOnlyTheBranchThatTurned) {
    const Motion motion;
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    const std::vector<Vec3>& rest = motion.body.mesh.vertices_mm;
    CholeskySolver solver;
    BlockMatrix matrix = test::assemble(motion.body, rest, {});
    solver.prepare(matrix, rest);
    const int all = solver.eliminated();
    for (int frame = 1; frame < 4; ++frame) {
        const auto positions = motion.positions(0.1 * frame, 100.0);
        matrix = test::assemble(motion.body, positions, {});
        std::vector<int> turned;
        for (int v = 0; v < matrix.rows(); ++v)
            if (rest[v].x() > 97.0) turned.push_back(v);
        solver.update(matrix, positions, turned);
        EXPECT_LT(solver.eliminated(), 0.6 * all);
        std::vector<Vec3> x(load.size()), y(load.size());
        solver.solve(load, x, {});
        CholeskySolver fresh;
        fresh.prepare(matrix, positions);
        fresh.solve(load, y, {});
        EXPECT_EQ(x, y);
    }
}

TEST(CholeskySolver, RecoversFromAMatrixThatIsNotFinite) {
    const Motion motion;
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    const auto positions = motion.positions(1.0, 0.0);
    const BlockMatrix good = test::assemble(motion.body, positions, {});
    BlockMatrix bad = good;
    for (Mat3& block : bad.block) block *= std::numeric_limits<double>::quiet_NaN();
    CholeskySolver solver;
    std::vector<Vec3> x(load.size(), Vec3::Zero());
    for (const bool broken : {true, false, false}) {
        solver.prepare(broken ? bad : good, positions);
        std::fill(x.begin(), x.end(), Vec3::Zero());
        const SolveReport report = solver.solve(load, x, {});
        EXPECT_EQ(report.converged, !broken);
        for (const Vec3& value : x) EXPECT_TRUE(value.allFinite());
    }
    EXPECT_LT(test::energy_error(good, x, test::solve_exactly(good, load)), 1e-2);
}

// A load that is not finite has no answer, and says so; the next one is solved as if it had not
// been.
TEST(LinearSolver, OwnsUpToALoadOrAMatrixThatIsNotFinite) {
    const Motion motion;
    const std::vector<Vec3>& rest = motion.body.mesh.vertices_mm;
    const BlockMatrix good = test::assemble(motion.body, rest, {});
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    BlockMatrix bad_matrix = good;
    bad_matrix.block[good.diagonal[good.rows() / 2]](1, 2) = std::nan("");
    for (const auto kind : {LinearSolverKind::block_jacobi, LinearSolverKind::skeleton,
                            LinearSolverKind::cholesky, LinearSolverKind::automatic})
        for (const double bad :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            const auto solver = make_linear_solver(kind, motion.body.skeleton, rest);
            const auto solve = [&](const BlockMatrix& matrix, const std::vector<Vec3>& rhs,
                                   bool solvable) {
                solver->prepare(matrix, rest);
                std::vector<Vec3> x(rhs.size(), Vec3::Zero());
                const SolveReport report = solver->solve(rhs, x, {});
                EXPECT_EQ(report.converged, solvable) << name_of(kind);
                EXPECT_TRUE(std::isfinite(report.relative_residual)) << name_of(kind);
                EXPECT_TRUE(std::isfinite(report.energy_error)) << name_of(kind);
                for (const Vec3& value : x) ASSERT_TRUE(value.allFinite()) << name_of(kind);
                if (solvable) return;
                for (const Vec3& value : x) ASSERT_EQ(value, Vec3(Vec3::Zero())) << name_of(kind);
            };
            std::vector<Vec3> broken = load;
            broken[7].y() = bad;
            solve(good, broken, false);
            solve(good, load, true);
            solve(bad_matrix, load, false);
            solve(good, load, true);
        }
}

// The matrix was not the reason, so that single precision does for later loads.
TEST(CholeskySolver, StaysInSinglePrecisionAfterALoadThatIsNotFinite) {
    const Motion motion;
    const std::vector<Vec3>& rest = motion.body.mesh.vertices_mm;
    const BlockMatrix matrix = test::assemble(motion.body, rest, {});
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    std::vector<Vec3> broken = load, x(load.size(), Vec3::Zero());
    broken[3].x() = std::nan("");
    CholeskySolver solver;
    solver.prepare(matrix, rest);
    EXPECT_FALSE(solver.solve(broken, x, {}).converged);
    EXPECT_TRUE(solver.in_single_precision());
    EXPECT_TRUE(solver.solve(load, x, {}).converged);
    EXPECT_LT(test::energy_error(matrix, x, test::solve_exactly(matrix, load)), 1e-2);
}

// A vertex without mass or stiffness: its pivots vanish and the report counts them.
TEST(CholeskySolver, ReportsDroppedPivots) {
    const Motion motion;
    const std::vector<Vec3>& rest = motion.body.mesh.vertices_mm;
    BlockMatrix matrix = test::assemble(motion.body, rest, {});
    std::vector<Vec3> load = test::make_load(motion.body, {}), x(load.size(), Vec3::Zero());
    CholeskySolver solver;
    solver.prepare(matrix, rest);
    EXPECT_EQ(solver.solve(load, x, {}).dropped_pivots, 0);
    const int lost = matrix.rows() / 2;
    for (int k = matrix.row_begin[lost]; k < matrix.row_begin[lost + 1]; ++k) {
        matrix.block[matrix.find(matrix.column[k], lost)].setZero();
        matrix.block[k].setZero();
    }
    load[lost].setZero();
    CholeskySolver other;
    other.prepare(matrix, rest);
    const SolveReport without = other.solve(load, x, {});
    EXPECT_EQ(without.dropped_pivots, 3);
    EXPECT_TRUE(without.converged);
    // No motion bears a load on what is lost, be it beside others or alone.
    load[lost] = Vec3(1, -2, 3).normalized() * std::sqrt(dot(load, load));
    const SolveReport beside = other.solve(load, x, {});
    EXPECT_EQ(beside.dropped_pivots, 3);
    EXPECT_FALSE(beside.converged);
    EXPECT_NEAR(beside.relative_residual, std::sqrt(0.5), 1e-3);
    EXPECT_GE(beside.energy_error, beside.relative_residual);
    for (int v = 0; v < matrix.rows(); ++v)
        if (v != lost) load[v].setZero();
    const SolveReport alone = other.solve(load, x, {});
    EXPECT_FALSE(alone.converged);
    EXPECT_EQ(alone.relative_residual, 1.0);
    EXPECT_EQ(alone.energy_error, 1.0);
}

TEST(CholeskySolver, FollowsAChangeOfPattern) {
    const Motion motion;
    CholeskySolver solver;
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    std::vector<Vec3> x(load.size());
    BlockMatrix matrix = test::assemble(motion.body, motion.body.mesh.vertices_mm, {});
    solver.prepare(matrix, motion.body.mesh.vertices_mm);
    // The bar tears in the middle: tetrahedra of one slice are gone.
    SampleBody torn = motion.body;
    std::erase_if(torn.mesh.tetrahedra, [&](const auto& t) {
        return std::abs(torn.mesh.vertices_mm[t[0]].x() - 60.0) < 0.1 &&
               torn.mesh.vertices_mm[t[3]].x() > 60.0;
    });
    matrix = test::assemble(torn, torn.mesh.vertices_mm, {});
    solver.prepare(matrix, torn.mesh.vertices_mm);
    EXPECT_TRUE(solver.solve(load, x, {.energy_tolerance = 1e-8}).converged);
    EXPECT_LT(test::energy_error(matrix, x, test::solve_exactly(matrix, load)), 1e-7);
}

TEST(AutomaticSolver, FactorsThinBodiesAndIteratesBulkyOnes) {
    for (const bool bulky : {false, true}) {
        const SampleBody body =
            bulky ? test::make_bar(60.0, 36.0, 15, 9) : test::make_bar(120.0, 6.0, 40, 2);
        const BlockMatrix matrix = test::assemble(body, body.mesh.vertices_mm, {});
        const auto solver =
            make_linear_solver(LinearSolverKind::automatic, body.skeleton, body.mesh.vertices_mm);
        solver->prepare(matrix, body.mesh.vertices_mm);
        const std::vector<Vec3> load = test::make_load(body, {});
        std::vector<Vec3> x(load.size(), Vec3::Zero());
        const SolveReport report = solver->solve(load, x, {.energy_tolerance = 1e-2});
        EXPECT_TRUE(report.converged);
        EXPECT_EQ(report.method, bulky ? "skeleton" : "cholesky");
        EXPECT_LE(test::energy_error(matrix, x, test::solve_exactly(matrix, load)), 1e-2);
    }
}

// The choice is made before a number of the factor is allocated.
TEST(AutomaticSolver, KeepsNoFactorThatItRejected) {
    for (const bool bulky : {false, true}) {
        const SampleBody body =
            bulky ? test::make_bar(60.0, 36.0, 15, 9) : test::make_bar(120.0, 6.0, 40, 2);
        const BlockMatrix matrix = test::assemble(body, body.mesh.vertices_mm, {});
        AutomaticSolver solver(body.skeleton, body.mesh.vertices_mm);
        EXPECT_EQ(solver.factor_bytes(), 0U);
        solver.prepare(matrix, body.mesh.vertices_mm);
        if (bulky) {
            EXPECT_EQ(solver.factor_bytes(), 0U);
        } else {
            EXPECT_GT(solver.factor_bytes(), 4 * 9 * matrix.column.size() / 2);
        }
    }
}

// Only the first step's time changes: the analysis is there before it.
TEST(LinearSolver, PlansAheadWithoutAChangeOfAnyBit) {
    const Motion motion;
    const auto positions = motion.positions(1.0, 0.0);
    const BlockMatrix matrix = test::assemble(motion.body, positions, {});
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    for (const LinearSolverKind kind : {LinearSolverKind::block_jacobi, LinearSolverKind::skeleton,
                                        LinearSolverKind::cholesky, LinearSolverKind::automatic}) {
        const auto fresh = [&] {
            return make_linear_solver(kind, motion.body.skeleton, motion.body.mesh.vertices_mm);
        };
        const auto solved = [&](LinearSolver& solver) {
            solver.prepare(matrix, positions);
            std::vector<Vec3> x(load.size(), Vec3::Zero());
            solver.solve(load, x, {});
            return x;
        };
        const auto plain = fresh(), ahead = fresh();
        const std::vector<double> memory = plain->memory();
        ahead->plan_ahead(matrix);
        EXPECT_EQ(ahead->memory(), memory) << name_of(kind);
        EXPECT_EQ(solved(*ahead), solved(*plain)) << name_of(kind);
        EXPECT_EQ(ahead->memory(), plain->memory()) << name_of(kind);
        ahead->restore(matrix, false, positions, memory);
        EXPECT_EQ(ahead->memory(), memory) << name_of(kind) << ", back before its first matrix";
    }
}

TEST(CholeskySolver, PlanningAheadLeavesOnlyTheNumbersToTheFirstUpdate) {
    const Motion motion;
    const BlockMatrix matrix = test::assemble(motion.body, motion.body.mesh.vertices_mm, {});
    CholeskySolver solver;
    solver.plan_ahead(matrix);
    const double planned = solver.tree().multiplications;
    EXPECT_GT(planned, 0.0);
    const std::size_t bytes = solver.bytes();
    EXPECT_GT(bytes, 4 * 9 * matrix.column.size() / 2);
    solver.prepare(matrix, motion.body.mesh.vertices_mm);
    EXPECT_EQ(solver.tree().multiplications, planned);
    EXPECT_EQ(solver.bytes(), bytes);
}

// A refused memory leaves the solver as it was.
TEST(LinearSolver, RefusesAMemoryThatNoSolverHas) {
    const Motion motion;
    const auto positions = motion.positions(1.0, 0.0);
    const BlockMatrix matrix = test::assemble(motion.body, positions, {});
    const std::vector<Vec3> load = test::make_load(motion.body, {});
    for (const LinearSolverKind kind :
         {LinearSolverKind::block_jacobi, LinearSolverKind::skeleton, LinearSolverKind::cholesky}) {
        const auto solver =
            make_linear_solver(kind, motion.body.skeleton, motion.body.mesh.vertices_mm);
        solver->prepare(matrix, positions);
        std::vector<Vec3> x(load.size(), Vec3::Zero());
        solver->solve(load, x, {});
        const std::vector<double> good = solver->memory();
        const bool kept = solver->made_from_latest();
        for (std::size_t k = 0; k < good.size(); ++k)
            for (const double wrong : {-0.5, std::nan(""), HUGE_VAL}) {
                std::vector<double> memory = good;
                memory[k] = wrong;
                EXPECT_THROW(solver->restore(matrix, kept, positions, memory), InputError)
                    << name_of(kind) << " " << k << " " << wrong;
                EXPECT_EQ(solver->memory(), good) << name_of(kind) << " " << k << " " << wrong;
            }
        EXPECT_NO_THROW(solver->restore(matrix, kept, positions, good)) << name_of(kind);
        EXPECT_EQ(solver->memory(), good) << name_of(kind);
    }
}

TEST(LinearSolver, NamesAndKindsBelongTogether) {
    for (const auto kind : {LinearSolverKind::block_jacobi, LinearSolverKind::skeleton,
                            LinearSolverKind::cholesky, LinearSolverKind::automatic}) {
        EXPECT_EQ(linear_solver_kind(name_of(kind)), kind);
        const SampleBody bar = test::make_bar(12.0, 6.0, 4, 2);
        EXPECT_EQ(make_linear_solver(kind, bar.skeleton, bar.mesh.vertices_mm)->name(),
                  name_of(kind));
    }
    EXPECT_THROW(linear_solver_kind("magic"), UsageError);
}

}  // namespace
}  // namespace hepatica
