// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of what the solvers are built of as they are today: skeletons, bindings, coarse spaces,
// orders of elimination, factors, sweeps, iterations and what they carry from matrix to matrix.
#include <gtest/gtest.h>

#include "core/deform/solvers/affine_coarse_space.h"
#include "core/deform/solvers/automatic_solver.h"
#include "core/deform/solvers/block_jacobi.h"
#include "core/deform/solvers/coupled_solve.h"
#include "core/deform/solvers/elimination_order.h"
#include "core/deform/solvers/error_bound.h"
#include "core/deform/solvers/gauss_seidel.h"
#include "core/deform/solvers/skeleton_preconditioner.h"
#include "core/mesh/brick_mesh.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/step_figures.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

using test::as_doubles;
using test::expect_recorded;
using test::Figures;
using test::flat;
using test::flat_arrays;
using test::random_field;

struct SolverFixture {
    test::SampleBody body = test::make_brick_tree(3, 3.0, 1.5);
    std::vector<Vec3> bent = test::bend(body.mesh.vertices_mm, 0.9, 40.0);
    BlockMatrix matrix = test::assemble(body, bent, {.poisson = 0.4});
    std::vector<Vec3> load = random_field(bent.size(), 1.0, 21);
};

void add_skeleton(Figures& figures, const std::string& name, const CoarseSkeleton& skeleton) {
    figures.add(name + ".positions", flat(skeleton.positions_mm))
        .add(name + ".parents", as_doubles(skeleton.parent))
        .add(name + ".radii", skeleton.radii_mm);
}

void add_tree(Figures& figures, const std::string& name, const EliminationTree& tree) {
    std::vector<double> supernodes, chains;
    for (const Supernode& s : tree.supernodes) {
        for (const int number : {s.first, s.count, s.rows_begin, s.rows_end, s.parent,
                                 s.children_begin, s.children_end, s.rest()})
            supernodes.push_back(number);
        supernodes.push_back(multiplications(s));
    }
    for (const auto& stage : tree.stages) {
        chains.push_back(-1.0);
        for (const EliminationTree::Chain& chain : stage) {
            chains.push_back(chain.begin);
            chains.push_back(chain.end);
        }
    }
    figures.add(name + ".order", as_doubles(tree.vertex_at))
        .add(name + ".supernodes", supernodes)
        .add(name + ".rows", as_doubles(tree.rows))
        .add(name + ".places", as_doubles(tree.place_in_parent))
        .add(name + ".children", as_doubles(tree.children))
        .add(name + ".chains", chains)
        .add(name + ".chain_supernodes", as_doubles(tree.chain_supernodes))
        .add(name + ".multiplications", tree.multiplications)
        .add(name + ".blocks", static_cast<double>(tree.factor_blocks));
}

TEST(SolverFigures, OfSkeletons) {
    const SolverFixture f;
    Figures figures;
    add_skeleton(figures, "resampled", f.body.skeleton);
    const SkeletonPolyline lines[] = {
        {{{0, 0, 0}, {3, 1, 0}, {9, 2, 1}, {14, 2, 4}}, {2.0, 1.8, 1.5, 1.1}, -1},
        {{{14, 2, 4}, {14.2, 2.1, 4.1}}, {1.0, 0.9}, 0},
        {{{14.2, 2.1, 4.1}, {18, 5, 6}, {25, 4, 7}}, {0.8, 0.7, 0.5}, 1},
        {{{40, 0, 0}}, {1.0}, -1}};
    add_skeleton(figures, "lines", resample(lines));
    add_skeleton(figures, "wide", resample(lines, 1.3));
    add_skeleton(figures, "of_tree", skeleton_of_mesh(f.body.mesh));
    TetMesh brick = kuhn_brick(Vec3(30, 5, 8), {12, 2, 3});
    for (Vec3& x : brick.vertices_mm) x.z() += 0.01 * x.x() * x.x();
    add_skeleton(figures, "of_brick", skeleton_of_mesh(brick));
    add_skeleton(figures, "of_brick_wide", skeleton_of_mesh(brick, 1.1));
    const SkeletonBinding binding = bind_vertices(f.body.skeleton, f.bent);
    figures.add("bound.nodes", flat_arrays(binding.nodes))
        .add("bound.weights", flat_arrays(binding.weights));
    figures.add("ends", as_doubles(order_from_ends(f.body.skeleton, binding)));
    expect_recorded("deform", "skeletons", figures);
}

TEST(SolverFigures, OfTheCoarseSpace) {
    const SolverFixture f;
    AffineCoarseSpace space(f.body.skeleton,
                            bind_vertices(f.body.skeleton, f.body.mesh.vertices_mm), f.matrix);
    space.set_shape(f.bent, f.body.fixed);
    Figures figures;
    std::vector<Vec3> coarse, fine = f.load;
    space.restrict_to_nodes(f.load, coarse);
    figures.add("restricted", flat(coarse));
    space.add_motion(coarse, fine);
    figures.add("moved", flat(fine)).add("centres", flat(space.centres_mm()));
    BlockMatrix projected = space.coarse_pattern();
    space.project(f.matrix, projected);
    figures.add("projected", flat(projected)).add("columns", as_doubles(projected.column));
    figures.add("nodes", space.node_count());
    std::vector<double> modes;
    for (const auto& pair : space.modes())
        for (const auto& mode : pair)
            for (int i = 0; i < 4; ++i) modes.push_back(mode[i]);
    expect_recorded("deform", "coarse_space", figures.add("modes", modes));
}

TEST(SolverFigures, OfOrdersAndFactors) {
    const SolverFixture f;
    Figures figures;
    const std::vector<int> order = fill_reducing_order(f.matrix);
    figures.add("order", as_doubles(order));
    std::vector<int> parents(f.bent.size());
    for (std::size_t i = 0; i < parents.size(); ++i) parents[i] = static_cast<int>(i);
    for (const int parent : {7, 40, 41, 7, static_cast<int>(f.bent.size())})
        parents.push_back(parent);
    figures.add("split_order", as_doubles(order_of_split(order, parents)));
    add_tree(figures, "tree", analyse(f.matrix, order));
    const std::vector<int> from_ends =
        order_from_ends(f.body.skeleton, bind_vertices(f.body.skeleton, f.body.mesh.vertices_mm));
    add_tree(figures, "tree_from_ends", analyse(f.matrix, from_ends));
    TreeCholesky factor(f.matrix, order);
    factor.factor(f.matrix);
    std::vector<Vec3> x(f.load.size());
    factor.solve(f.load, x);
    figures.add("solved", flat(x)).add("form", factor.inverse_form(f.load));
    figures.add("bytes", static_cast<double>(factor.bytes()));
    BlockMatrix changed = f.matrix;
    const int rows[] = {30, 31, 32};
    for (const int row : rows) changed.block[changed.diagonal[row]] *= 1.5;
    factor.refactor(changed, rows);
    factor.solve(f.load, x);
    figures.add("eliminated", factor.eliminated()).add("solved_again", flat(x));
    changed.block[changed.diagonal[31]] *= -1.0;
    factor.factor(changed);
    factor.solve(f.load, x);
    figures.add("dropped", factor.dropped_pivots()).add("solved_indefinite", flat(x));
    expect_recorded("deform", "factors", figures);
}

TEST(SolverFigures, OfSweeps) {
    const SolverFixture f;
    const std::vector<int> order =
        order_from_ends(f.body.skeleton, bind_vertices(f.body.skeleton, f.body.mesh.vertices_mm));
    GaussSeidel sweep(f.matrix, order);
    sweep.prepare(f.matrix);
    std::vector<Vec3> z(f.load.size()), rest(f.load.size()), product;
    Figures figures;
    sweep.forward(f.load, z, rest);
    figures.add("forward", flat(z)).add("rest", flat(rest)).add("colours", sweep.colours());
    sweep.backward(f.load, z);
    figures.add("backward", flat(z));
    SkeletonPreconditioner preconditioner(f.body.skeleton, f.body.mesh.vertices_mm);
    preconditioner.prepare(f.matrix, f.bent);
    preconditioner.apply(f.load, z);
    figures.add("preconditioned", flat(z));
    multiply(f.matrix, f.load, product);
    figures.add("product", flat(product)).add("lone", as_doubles(lone_vertices(f.matrix)));
    std::vector<double> inverses;
    for (const Mat3& inverse : inverse_diagonal(f.matrix))
        inverses.insert(inverses.end(), inverse.data(), inverse.data() + 9);
    expect_recorded("deform", "sweeps", figures.add("inverse_diagonal", inverses));
}

// A series of matrices of a body that bends, with a preconditioner that is kept where it lasts.
TEST(SolverFigures, OfASeriesOfMatrices) {
    const SolverFixture f;
    for (const LinearSolverKind kind : {LinearSolverKind::block_jacobi, LinearSolverKind::skeleton,
                                        LinearSolverKind::cholesky, LinearSolverKind::automatic}) {
        const auto solver = make_linear_solver(kind, f.body.skeleton, f.body.mesh.vertices_mm);
        std::vector<double> solutions, iterations;
        std::vector<BlockMatrix> matrices;
        for (int k = 0; k < 6; ++k)
            matrices.push_back(test::assemble(
                f.body, test::bend(f.body.mesh.vertices_mm, 0.1 + 0.35 * k, 40.0), {}));
        for (int k = 0; k < 6; ++k) {
            solver->prepare(matrices[k], test::bend(f.body.mesh.vertices_mm, 0.1 + 0.35 * k, 40.0));
            std::vector<Vec3> x(f.load.size(), Vec3::Zero()), z(f.load.size());
            const SolveReport report =
                solver->solve(f.load, x, {.energy_tolerance = k == 4 ? 1e-6 : 1e-2});
            for (const double number : flat(x)) solutions.push_back(number);
            solver->precondition(f.load, z);
            for (const double number : flat(z)) solutions.push_back(number);
            for (const double number :
                 {1.0 * report.iterations, 1.0 * report.converged, 1.0 * report.dropped_pivots,
                  1.0 * solver->made_from_latest(),
                  1.0 * static_cast<double>(solver->memory().size())})
                iterations.push_back(number);
        }
        expect_recorded("deform", "series_" + std::string(name_of(kind)),
                        Figures().add("solutions", solutions).add("iterations", iterations));
    }
}

TEST(SolverFigures, OfErrorBounds) {
    std::vector<double> bounds;
    for (const double known : {0.0, 0.3}) {
        ErrorBound bound(known);
        bounds.push_back(known > 0.0 ? bound.before() : -1.0);
        for (int k = 1; k < 20; ++k) {
            const double after = bound.after(0.4 + 0.05 * (k % 3), 0.5 + 0.02 * (k % 5));
            bounds.push_back(std::isfinite(after) ? after : -2.0);
            bounds.push_back(std::isfinite(bound.smallest()) ? bound.smallest() : -3.0);
        }
    }
    expect_recorded("deform", "error_bounds", Figures().add("all", bounds));
}

TEST(SolverFigures, OfCoupledSystems) {
    const SolverFixture f;
    const int last = static_cast<int>(f.load.size()) - 1;
    const Coupling coupling = [&](std::span<const Vec3> d, std::span<Vec3> product) {
        product[20] -= 0.3 * d[last];
        product[last] -= 0.3 * d[20];
    };
    BlockMatrix matrix = f.matrix;
    for (const int row : {20, last})
        matrix.block[matrix.diagonal[row]] += 0.3 * Mat3(Mat3::Identity());
    Figures figures;
    for (const bool held : {false, true}) {
        std::vector<std::uint8_t> holds(f.load.size(), 0);
        if (held) holds.assign(f.body.fixed.begin(), f.body.fixed.end());
        const auto solver = make_linear_solver(LinearSolverKind::skeleton, f.body.skeleton,
                                               f.body.mesh.vertices_mm);
        solver->prepare(matrix, f.bent);
        std::vector<Vec3> rhs = f.load, x(f.load.size(), Vec3::Zero());
        for (std::size_t i = 0; i < rhs.size(); ++i)
            if (holds[i] != 0) rhs[i].setZero();
        const SolveReport report =
            solve_coupled(*solver, matrix, coupling, holds, rhs, x, {.energy_tolerance = 1e-3});
        const std::string name = held ? "held" : "free";
        figures.add(name, flat(x)).add(name + ".iterations", report.iterations);
        figures.add(name + ".error", report.energy_error);
    }
    expect_recorded("deform", "coupled", figures);
}

}  // namespace
}  // namespace hepatica
