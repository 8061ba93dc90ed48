// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/tree_cholesky.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "core/base/parallel.h"
#include "core/deform/solvers/elimination_order.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

using test::SampleBody;

using Graph = std::vector<std::set<int>>;  // of each row, itself included

Graph random_graph(int rows, int edges, std::mt19937& random) {
    Graph columns(static_cast<std::size_t>(rows));
    for (int i = 0; i < rows; ++i) columns[i].insert(i);
    for (int e = 0; e < edges; ++e) {
        const int i = static_cast<int>(random() % static_cast<unsigned>(rows));
        const int j = static_cast<int>(random() % static_cast<unsigned>(rows));
        columns[i].insert(j);
        columns[j].insert(i);
    }
    return columns;
}

// A random symmetric positive definite matrix.
BlockMatrix random_matrix(const Graph& columns, std::mt19937& random) {
    const int rows = static_cast<int>(columns.size());
    BlockMatrix matrix;
    for (int i = 0; i < rows; ++i) {
        for (const int j : columns[i]) {
            if (j == i) matrix.diagonal.push_back(static_cast<int>(matrix.column.size()));
            matrix.column.push_back(j);
        }
        matrix.row_begin.push_back(static_cast<int>(matrix.column.size()));
    }
    matrix.block.assign(matrix.column.size(), Mat3::Zero());
    for (int i = 0; i < rows; ++i) {
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k) {
            const int j = matrix.column[k];
            if (j >= i) continue;
            Mat3 block;
            for (int n = 0; n < 9; ++n) {
                block(n) = static_cast<double>(random()) / 2147483648.0 - 1.0;
            }
            matrix.block[k] = block;
            matrix.block[matrix.find(j, i)] = block.transpose();
            matrix.block[matrix.diagonal[i]] += 3.1 * Mat3::Identity();
            matrix.block[matrix.diagonal[j]] += 3.1 * Mat3::Identity();
        }
        matrix.block[matrix.diagonal[i]] += 0.1 * Mat3::Identity();
    }
    return matrix;
}

BlockMatrix random_matrix(int rows, int edges, std::mt19937& random) {
    return random_matrix(random_graph(rows, edges, random), random);
}

std::vector<Vec3> random_vectors(int count, std::mt19937& random) {
    std::vector<Vec3> values(static_cast<std::size_t>(count));
    for (Vec3& value : values) {
        for (int a = 0; a < 3; ++a) value[a] = static_cast<double>(random()) / 2147483648.0 - 1.0;
    }
    return values;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double largest = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, (a[i] - b[i]).cwiseAbs().maxCoeff());
        scale = std::max(scale, b[i].cwiseAbs().maxCoeff());
    }
    return largest / scale;
}

TEST(TreeCholesky, SolvesRandomSystemsInAnyOrder) {
    std::mt19937 random(3);
    for (const int rows : {1, 2, 3, 7, 20, 61, 150}) {
        for (const int density : {0, 1, 3, 10}) {
            const BlockMatrix matrix = random_matrix(rows, rows * density, random);
            std::vector<int> order(static_cast<std::size_t>(rows));
            std::iota(order.begin(), order.end(), 0);
            std::shuffle(order.begin(), order.end(), random);
            TreeCholesky factor(matrix, order);
            factor.factor(matrix);
            EXPECT_EQ(factor.dropped_pivots(), 0);
            const std::vector<Vec3> b = random_vectors(rows, random);
            std::vector<Vec3> x(b.size());
            factor.solve(b, x);
            EXPECT_LT(largest_difference(x, test::solve_exactly(matrix, b)), 1e-11)
                << rows << " rows, density " << density;
        }
    }
}

TEST(TreeCholesky, FactorsABentTreeFromItsEnds) {
    const SampleBody body = test::make_brick_tree(4, 3.0, 1.0);
    const auto positions = test::bend(body.mesh.vertices_mm, 2.0, 90.0);
    const BlockMatrix matrix = test::assemble(body, positions, {});
    const SkeletonBinding binding = bind_vertices(body.skeleton, body.mesh.vertices_mm);
    TreeCholesky factor(matrix, order_from_ends(body.skeleton, binding));
    factor.factor(matrix);
    EXPECT_EQ(factor.dropped_pivots(), 0);
    const std::vector<Vec3> load = test::make_load(body, {});
    std::vector<Vec3> x(load.size());
    factor.solve(load, x);
    EXPECT_LT(test::energy_error(matrix, x, test::solve_exactly(matrix, load)), 1e-8);
}

TEST(TreeCholesky, SameBitsForAnyNumberOfThreads) {
    const auto body = test::make_brick_tree(4, 3.0, 1.0);
    const BlockMatrix matrix = test::assemble(body, body.mesh.vertices_mm, {});
    const SkeletonBinding binding = bind_vertices(body.skeleton, body.mesh.vertices_mm);
    const std::vector<Vec3> load = test::make_load(body, {});
    std::vector<std::vector<Vec3>> results;
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        TreeCholesky factor(matrix, order_from_ends(body.skeleton, binding));
        factor.factor(matrix);
        results.emplace_back(load.size());
        factor.solve(load, results.back());
    }
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(results[0], results[2]);
}

TEST(TreeCholesky, RefactorsWhatChangedToTheSameBits) {
    const auto body = test::make_brick_tree(4, 3.0, 1.2);
    const std::vector<Vec3>& rest = body.mesh.vertices_mm;
    const BlockMatrix matrix = test::assemble(body, rest, {});
    const SkeletonBinding binding = bind_vertices(body.skeleton, rest);
    const std::vector<int> order = order_from_ends(body.skeleton, binding);
    // One twig turns by 0.3 rad about its tip.
    std::vector<Vec3> moved = rest;
    std::vector<int> changed;
    const Vec3 tip = body.skeleton.positions_mm.back();
    std::vector<char> touched(rest.size(), 0);
    for (std::size_t v = 0; v < rest.size(); ++v) {
        if ((rest[v] - tip).norm() > 9.0) continue;
        touched[v] = 1;
        const Vec3 arm = rest[v] - tip;
        moved[v] = tip + Vec3(std::cos(0.3) * arm.x() - std::sin(0.3) * arm.y(),
                              std::sin(0.3) * arm.x() + std::cos(0.3) * arm.y(), arm.z());
    }
    std::vector<char> marked(rest.size(), 0);
    for (const auto& t : body.mesh.tetrahedra) {
        if (touched[t[0]] || touched[t[1]] || touched[t[2]] || touched[t[3]]) {
            for (const int v : t) marked[v] = 1;
        }
    }
    for (std::size_t v = 0; v < rest.size(); ++v) {
        if (marked[v]) changed.push_back(static_cast<int>(v));
    }
    const BlockMatrix turned = test::assemble(body, moved, {});
    const std::vector<Vec3> load = test::make_load(body, {});
    TreeCholesky fresh(matrix, order), updated(matrix, order);
    fresh.factor(turned);
    updated.factor(matrix);
    updated.refactor(turned, changed);
    EXPECT_LT(updated.eliminated(), fresh.eliminated());
    EXPECT_GT(updated.eliminated(), 0);
    std::vector<Vec3> x(load.size()), y(load.size());
    fresh.solve(load, x);
    updated.solve(load, y);
    EXPECT_EQ(x, y);
}

// A brick of nodes, each joined to its 26 neighbours, slice after slice along its length.
BlockMatrix brick_pattern(int length, int width) {
    BlockMatrix pattern;
    for (int x = 0; x < length; ++x)
        for (int y = 0; y < width; ++y)
            for (int z = 0; z < width; ++z) {
                for (int i = std::max(0, x - 1); i <= std::min(length - 1, x + 1); ++i)
                    for (int j = std::max(0, y - 1); j <= std::min(width - 1, y + 1); ++j)
                        for (int k = std::max(0, z - 1); k <= std::min(width - 1, z + 1); ++k) {
                            if (i == x && j == y && k == z)
                                pattern.diagonal.push_back(static_cast<int>(pattern.column.size()));
                            pattern.column.push_back((i * width + j) * width + k);
                        }
                pattern.row_begin.push_back(static_cast<int>(pattern.column.size()));
            }
    return pattern;
}

// Rows of every column would take 85 MB here. (The peak is the process's: run alone, as ctest
// does. Sanitizers keep what was freed, so that the peak says nothing under them.)
TEST(EliminationTree, AnalysisHoldsTheRowsOfSupernodesAlone) {
    const BlockMatrix pattern = brick_pattern(60, 24);
    std::vector<int> order(pattern.diagonal.size());
    std::iota(order.begin(), order.end(), 0);
    const auto peak_kb = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss;
    };
    const long before = peak_kb();
    const EliminationTree tree = analyse(pattern, order);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LT(peak_kb() - before, 30000);
#else
    EXPECT_GT(peak_kb(), before);
#endif
    EXPECT_GT(tree.factor_blocks, 20000000U);
    EXPECT_LT(tree.rows.size(), 1000000U);
}

// Cliques of the given sizes, each tied to the last vertices, which are a clique, too.
BlockMatrix cliques_on_a_root(const std::vector<int>& sizes, int root) {
    const int rows = std::accumulate(sizes.begin(), sizes.end(), root);
    std::vector<int> clique(static_cast<std::size_t>(rows), -1);  // -1: the root
    int row = 0;
    for (std::size_t c = 0; c < sizes.size(); ++c)
        for (int k = 0; k < sizes[c]; ++k) clique[row++] = static_cast<int>(c);
    BlockMatrix matrix;
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < rows; ++j) {
            if (clique[i] >= 0 && clique[j] >= 0 && clique[i] != clique[j]) continue;
            if (i == j) matrix.diagonal.push_back(static_cast<int>(matrix.column.size()));
            matrix.column.push_back(j);
            matrix.block.push_back(i == j ? Mat3(200.0 * Mat3::Identity()) : Mat3::Ones());
        }
        matrix.row_begin.push_back(static_cast<int>(matrix.column.size()));
    }
    return matrix;
}

// Chains of one stage run beside each other: what a front takes from its children must be there.
TEST(EliminationTree, ChildrenComeInAnEarlierStageOrEarlierInTheChain) {
    std::mt19937 random(11);
    int fronts_with_children = 0;
    for (int trial = 0; trial < 60; ++trial) {
        std::vector<int> sizes;
        for (int c = 0; c < 1 + trial % 6; ++c)
            sizes.push_back(1 + static_cast<int>(random() % 60));
        const BlockMatrix matrix = cliques_on_a_root(sizes, 1 + static_cast<int>(random() % 30));
        std::vector<int> order(static_cast<std::size_t>(matrix.rows()));
        std::iota(order.begin(), order.end(), 0);
        const EliminationTree tree = analyse(matrix, order);
        std::vector<std::array<int, 3>> place(
            tree.supernodes.size());  // stage, chain, in the chain
        for (std::size_t stage = 0; stage < tree.stages.size(); ++stage)
            for (std::size_t chain = 0; chain < tree.stages[stage].size(); ++chain)
                for (int k = tree.stages[stage][chain].begin; k < tree.stages[stage][chain].end;
                     ++k)
                    place[tree.chain_supernodes[k]] = {static_cast<int>(stage),
                                                       static_cast<int>(chain), k};
        for (std::size_t s = 0; s < tree.supernodes.size(); ++s)
            for (int c = tree.supernodes[s].children_begin; c < tree.supernodes[s].children_end;
                 ++c) {
                const auto& child = place[tree.children[c]];
                const bool in_order = child[0] == place[s][0] && child[1] == place[s][1]
                                          ? child[2] < place[s][2]
                                          : child[0] < place[s][0];
                EXPECT_TRUE(in_order) << "trial " << trial << ", front " << s;
                ++fronts_with_children;
            }
    }
    EXPECT_GT(fronts_with_children, 60);
}

// Splits random nodes of the graph, some of them again: each neighbour stays with one of the two,
// which may be bound to each other.
std::vector<int> split_randomly(Graph& graph, int splits, std::mt19937& random) {
    std::vector<int> parents(graph.size());
    std::iota(parents.begin(), parents.end(), 0);
    for (int n = 0; n < splits; ++n) {
        const int old = static_cast<int>(random() % graph.size());
        const int added = static_cast<int>(graph.size());
        graph.push_back({added});
        parents.push_back(old);
        const std::set<int> neighbours = graph[old];
        for (const int other : neighbours) {
            if (other == old || random() % 2 == 0) continue;
            graph[old].erase(other);
            graph[other].erase(old);
            graph[added].insert(other);
            graph[other].insert(added);
        }
        if (random() % 2 == 0) continue;
        graph[old].insert(added);
        graph[added].insert(old);
    }
    return parents;
}

TEST(EliminationTree, OfASplitBodySolvesAsOneThatIsAnalysedAnew) {
    std::mt19937 random(11);
    for (int trial = 0; trial < 20; ++trial) {
        Graph graph = random_graph(150, 260, random);
        const BlockMatrix before = random_matrix(graph, random);
        const std::vector<int> order = fill_reducing_order(before);
        const EliminationTree whole = analyse(before, order);
        TreeCholesky factor(before, whole);
        factor.factor(before);
        for (const int splits : {0, 3, 40}) {
            Graph torn = graph;
            const std::vector<int> parents = split_randomly(torn, splits, random);
            const BlockMatrix matrix = random_matrix(torn, random);
            const EliminationTree tree = tree_of_split(whole, parents);
            if (splits == 0) {
                EXPECT_EQ(tree.vertex_at, whole.vertex_at);
                EXPECT_EQ(tree.rows, whole.rows);
                EXPECT_EQ(tree.multiplications, whole.multiplications);
            }
            TreeCholesky anew(matrix, order_of_split(order, parents)), expanded(matrix, tree);
            anew.factor(matrix);
            expanded.factor(matrix);
            factor.plan(matrix, tree);  // in the memory of another
            factor.factor(matrix);
            const auto load = random_vectors(matrix.rows(), random);
            std::vector<Vec3> x(load.size()), by_expanded(load.size()), by_kept(load.size());
            anew.solve(load, x);
            expanded.solve(load, by_expanded);
            factor.solve(load, by_kept);
            EXPECT_LT(largest_difference(by_expanded, x), 1e-11);
            EXPECT_EQ(by_kept, by_expanded);
        }
    }
}

TEST(TreeCholesky, DropsPivotsOfASemidefiniteMatrix) {
    std::mt19937 random(11);
    BlockMatrix matrix = random_matrix(30, 60, random);
    // Vertex 7 takes part in nothing and weighs nothing.
    for (int k = matrix.row_begin[7]; k < matrix.row_begin[8]; ++k) {
        const int other = matrix.find(matrix.column[k], 7);
        matrix.block[k].setZero();
        matrix.block[other].setZero();
    }
    std::vector<int> order(30);
    std::iota(order.begin(), order.end(), 0);
    TreeCholesky factor(matrix, order);
    factor.factor(matrix);
    EXPECT_EQ(factor.dropped_pivots(), 3);
    std::vector<Vec3> b = random_vectors(30, random), x(30), product;
    factor.solve(b, x);
    EXPECT_EQ(x[7], Vec3(Vec3::Zero()));
    multiply(matrix, x, product);
    b[7].setZero();
    EXPECT_LT(largest_difference(product, b), 1e-11);
}

// Loads of one vertex, of several far from each other, and of none; some share a way to the root.
TEST(TreeCholesky, GivesTheBlockOfTheInverseBetweenAFewLoads) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        std::mt19937 random(seed);
        const int rows = 20 + static_cast<int>(random() % 60);
        const BlockMatrix matrix = random_matrix(rows, 3 * rows, random);
        TreeCholesky factor(matrix, fill_reducing_order(matrix));
        factor.factor(matrix);
        std::vector<SparseLoad> loads(6);
        for (std::size_t l = 0; l + 1 < loads.size(); ++l)
            for (std::size_t i = 0; i <= l; ++i) {
                loads[l].vertices.push_back(
                    static_cast<int>(random() % static_cast<unsigned>(rows)));
                loads[l].forces.push_back(random_vectors(1, random)[0]);
            }
        const Eigen::MatrixXd block = factor.inverse_block(loads);
        for (std::size_t l = 0; l < loads.size(); ++l) {
            std::vector<Vec3> b(static_cast<std::size_t>(rows), Vec3::Zero()), x(b.size());
            for (std::size_t i = 0; i < loads[l].vertices.size(); ++i)
                b[loads[l].vertices[i]] += loads[l].forces[i];
            factor.solve(b, x);
            for (std::size_t k = 0; k < loads.size(); ++k) {
                double sum = 0.0;
                for (std::size_t i = 0; i < loads[k].vertices.size(); ++i)
                    sum += loads[k].forces[i].dot(x[loads[k].vertices[i]]);
                EXPECT_NEAR(block(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l)), sum,
                            1e-12);
            }
        }
    }
}

}  // namespace
}  // namespace hepatica
