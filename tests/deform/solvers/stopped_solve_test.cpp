// SPDX-License-Identifier: GPL-3.0-or-later
// A stop that is asked for while a system is solved: heard before the next iteration, and between
// the columns of a factorisation, so that no size of a system makes anybody wait.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/deform/solvers/conjugate_gradient.h"
#include "core/deform/solvers/coupled_solve.h"
#include "core/deform/solvers/dense_front.h"
#include "core/deform/solvers/elimination_order.h"
#include "core/deform/solvers/skeleton_preconditioner.h"
#include "core/deform/solvers/tree_cholesky.h"
#include "tests/deform/support/test_bodies.h"
#include "tests/support/asked_to_stop.h"

namespace hepatica {
namespace {

struct System {
    test::SampleBody body = test::make_bar(60.0, 6.0, 20, 2);
    BlockMatrix matrix = test::assemble(body, body.mesh.vertices_mm, {});
    std::vector<Vec3> load = test::make_load(body, {});
    std::vector<Vec3> x = std::vector<Vec3>(load.size(), Vec3::Zero());
};

TEST(StoppedSolve, ConjugateGradientsEndBeforeTheNextIteration) {
    System system;
    std::stop_source source;
    int products = 0;
    const ConjugateGradient::Product apply = [&](const std::vector<Vec3>& a,
                                                 std::vector<Vec3>& product) {
        multiply(system.matrix, a, product);
        if (++products == 5) source.request_stop();
    };
    const auto itself = [](const std::vector<Vec3>& r, std::vector<Vec3>& z) { z = r; };
    const SolveLimits limits{.energy_tolerance = 0.0, .max_iterations = 50};
    ConjugateGradient iteration;
    iteration.remember(0.25);
    EXPECT_THROW(iteration.solve(apply, itself, system.load, system.x, limits, source.get_token()),
                 Cancelled);
    EXPECT_EQ(products, 5);
    EXPECT_EQ(iteration.smallest_ritz(), 0.25);
    iteration.solve(apply, itself, system.load, system.x, limits);
    EXPECT_EQ(products, 5 + 50 + 1);  // and one for the warm start
}

// Every kind, where it factors or prepares and where it iterates.
TEST(StoppedSolve, EverySolverHearsItAndGoesOnOnceItIsRestored) {
    for (const LinearSolverKind kind : {LinearSolverKind::block_jacobi, LinearSolverKind::skeleton,
                                        LinearSolverKind::cholesky, LinearSolverKind::automatic}) {
        SCOPED_TRACE(name_of(kind));
        System system;
        const std::vector<Vec3>& rest = system.body.mesh.vertices_mm;
        const SolveLimits limits{.energy_tolerance = 1e-12};
        const auto solver = make_linear_solver(kind, system.body.skeleton, rest);
        solver->prepare(system.matrix, rest);
        solver->solve(system.load, system.x, limits);
        const std::vector<Vec3> answer = system.x;
        const std::vector<double> memory = solver->memory();
        const bool kept = solver->made_from_latest();
        solver->heed(test::asked_to_stop());
        EXPECT_THROW(
            {
                solver->prepare(system.matrix, rest);
                solver->solve(system.load, system.x, limits);
            },
            Cancelled);
        solver->restore(system.matrix, kept, rest, memory);
        solver->heed({});
        solver->prepare(system.matrix, rest);
        system.x.assign(system.x.size(), Vec3::Zero());
        EXPECT_TRUE(solver->solve(system.load, system.x, limits).converged);
        for (std::size_t i = 0; i < answer.size(); ++i)
            EXPECT_LT((system.x[i] - answer[i]).norm(), 1e-9 * (1.0 + answer[i].norm()));
    }
}

// Preparing and solving each hear it, so that neither leaves it to the other. Afterwards the solver
// is of no use until it is restored; each has its own here.
TEST(StoppedSolve, PreparingAndSolvingHearItEach) {
    System system;
    const std::vector<Vec3>& rest = system.body.mesh.vertices_mm;
    const SolveLimits limits{.energy_tolerance = 1e-12};
    const auto make = [&](LinearSolverKind kind) {
        return make_linear_solver(kind, system.body.skeleton, rest);
    };
    for (const LinearSolverKind kind :
         {LinearSolverKind::skeleton, LinearSolverKind::cholesky, LinearSolverKind::automatic}) {
        const auto solver = make(kind);
        solver->heed(test::asked_to_stop());
        EXPECT_THROW(solver->prepare(system.matrix, rest), Cancelled) << name_of(kind);
    }
    const auto direct = make(LinearSolverKind::cholesky);
    direct->prepare(system.matrix, rest);
    direct->heed(test::asked_to_stop());
    EXPECT_THROW(direct->prepare(system.matrix, rest), Cancelled) << "factored once more";
    for (const LinearSolverKind kind :
         {LinearSolverKind::skeleton, LinearSolverKind::cholesky, LinearSolverKind::block_jacobi}) {
        const auto solver = make(kind);
        solver->prepare(system.matrix, rest);
        solver->heed(test::asked_to_stop());
        EXPECT_THROW(solver->solve(system.load, system.x, limits), Cancelled) << name_of(kind);
    }
}

TEST(StoppedSolve, PreparingATwoLevelMethodHearsIt) {
    System system;
    const std::vector<Vec3>& rest = system.body.mesh.vertices_mm;
    SkeletonPreconditioner preconditioner(system.body.skeleton, rest);
    EXPECT_THROW(preconditioner.prepare(system.matrix, rest, test::asked_to_stop()), Cancelled);
    EXPECT_NO_THROW(preconditioner.prepare(system.matrix, rest));
}

TEST(StoppedSolve, AFactorisationHearsItWithinAFront) {
    System system;
    TreeCholesky factor(system.matrix, fill_reducing_order(system.matrix));
    EXPECT_THROW(factor.factor(system.matrix, test::asked_to_stop()), Cancelled);
    const std::vector<int> changed{0};
    EXPECT_NO_THROW(factor.factor(system.matrix));
    EXPECT_THROW(factor.refactor(system.matrix, changed, test::asked_to_stop()), Cancelled);

    std::vector<double> panel(8 * 4 + 4, 0.0), remainder(4 * 4 + 4, 0.0);
    EXPECT_THROW(
        factor_front(panel.data(), remainder.data(), 4, 0, {1e-14, true}, test::asked_to_stop()),
        Cancelled);
    EXPECT_THROW(
        factor_front(panel.data(), remainder.data(), 0, 4, {1e-14, true}, test::asked_to_stop()),
        Cancelled);
    EXPECT_NO_THROW(factor_front(panel.data(), remainder.data(), 4, 4, {1e-14, true}));
}

TEST(StoppedSolve, SurfacesThatTouchAreNoExcuse) {
    System system;
    const auto solver = make_block_jacobi_solver();
    solver->prepare(system.matrix, system.body.mesh.vertices_mm);
    const std::vector<std::uint8_t> held(system.load.size(), 0);
    const Coupling none = [](std::span<const Vec3>, std::span<Vec3>) {};
    EXPECT_THROW(solve_coupled(*solver, system.matrix, none, held, system.load, system.x, {},
                               test::asked_to_stop()),
                 Cancelled);
}

}  // namespace
}  // namespace hepatica
