// SPDX-License-Identifier: GPL-3.0-or-later
// The factor that knows couplings, against a dense factorisation of all: with the couplings of its
// pattern, with later ones, and restored.
#include "core/deform/solvers/coupled_factor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/deform/solvers/coupled_solve.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/sprung_bars.h"

namespace hepatica {
namespace {

using test::dense_errors;
using test::DenseErrors;
using test::SprungBars;

struct Solved {
    SolveReport report;
    std::vector<Vec3> x;
};

std::vector<int> all_rows(const SprungBars& bars) {
    std::vector<int> rows(static_cast<std::size_t>(bars.nodes));
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

std::vector<Vec3> load_of(const SprungBars& bars) {
    return test::random_field(bars.nodes, 1.0, 7);
}

Solved solve(CoupledFactor& factor, const SprungBars& bars, double tolerance,
             std::span<const int> changed_rows) {
    const std::vector<std::uint8_t> held(bars.nodes, 0);
    Solved solved{{}, std::vector<Vec3>(bars.nodes, Vec3::Zero())};
    solved.report = factor.solve(bars.matrix, changed_rows, bars.coupling, held, load_of(bars),
                                 solved.x, {.energy_tolerance = tolerance});
    return solved;
}

Solved solve(CoupledFactor& factor, const SprungBars& bars, double tolerance = 1e-6) {
    return solve(factor, bars, tolerance, all_rows(bars));
}

void expect_solved(const SprungBars& bars, const Solved& solved, double tolerance) {
    EXPECT_TRUE(solved.report.converged);
    const DenseErrors errors = dense_errors(bars.dense(), load_of(bars), solved.x);
    EXPECT_LT(errors.energy, tolerance);
    EXPECT_LT(errors.sum, 1e-10);
}

TEST(CoupledFactor, SolvesTheWholeMatrixAndKeepsTheSumOfTheResidual) {
    SprungBars bars;
    bars.tie(0, 40);
    for (const double tolerance : {1e-2, 1e-6}) {
        CoupledFactor factor;
        expect_solved(bars, solve(factor, bars, tolerance), tolerance);
    }
}

TEST(CoupledFactor, TakesAsManyIterationsForManyCouplingsAsForFew) {
    SprungBars bars;
    const std::vector<std::uint8_t> held(bars.nodes, 0);
    int few_without = 0;
    for (const int count : {10, 20, 40}) {
        bars.tie(0, count);
        CoupledFactor factor;
        EXPECT_LE(solve(factor, bars, 1e-4).report.iterations, 6) << count;
        // The factor of A alone does not know them.
        const auto solver = make_linear_solver(LinearSolverKind::cholesky, {}, {});
        solver->prepare(bars.matrix, {});
        std::vector<Vec3> x(bars.nodes, Vec3::Zero());
        const Coupling apply = [&](std::span<const Vec3> d, std::span<Vec3> product) {
            add_product(bars.coupling, d, product);
        };
        const int without = solve_coupled(*solver, bars.matrix, apply, held, load_of(bars), x,
                                          {.energy_tolerance = 1e-4})
                                .iterations;
        if (count == 10) few_without = without;
        if (count == 40) {
            EXPECT_GT(without, 2 * few_without);
        }
    }
}

TEST(CoupledFactor, PaysForManyCouplingsOnly) {
    SprungBars bars;
    CoupledFactor factor;
    bars.tie(0, 5);
    EXPECT_FALSE(factor.pays(bars.matrix, bars.coupling));
    EXPECT_EQ(factor.analyses(), 0);
    bars.tie(0, 40);
    EXPECT_TRUE(factor.pays(bars.matrix, bars.coupling));
    EXPECT_EQ(factor.analyses(), 1);
}

// Nodes joined at random: the factor is nearly full, and would be no smaller for any order.
BlockMatrix joined_at_random(int nodes) {
    std::mt19937 random(5);
    std::vector<std::vector<int>> rows(nodes);
    const auto join = [&](int a, int b) {
        if (std::ranges::find(rows[a], b) == rows[a].end()) rows[a].push_back(b);
    };
    for (int i = 0; i < nodes; ++i) {
        join(i, i);
        for (int k = 0; k < 6; ++k) {
            const int other = static_cast<int>(random() % nodes);
            join(i, other);
            join(other, i);
        }
    }
    BlockMatrix matrix;
    for (std::vector<int>& row : rows) {
        std::ranges::sort(row);
        matrix.column.insert(matrix.column.end(), row.begin(), row.end());
        matrix.row_begin.push_back(static_cast<int>(matrix.column.size()));
    }
    matrix.block.assign(matrix.column.size(), Mat3::Zero());
    return matrix;
}

// Of the nodes from `first` on with those of the other half.
CouplingBlocks couplings(int first, int count) {
    CouplingBlocks all;
    for (int i = first; i < first + count; ++i) all.push_back({{{{i, i + 500, Mat3::Zero()}}}, 1});
    return all;
}

TEST(CoupledFactor, DoesNotPayWhereItFills) {
    CoupledFactor factor;
    EXPECT_FALSE(factor.pays(joined_at_random(1000), couplings(0, 10)));
    EXPECT_EQ(factor.analyses(), 1);
}

// Contacts that wander over a thick body would be analysed in every step; fewer might pay.
TEST(CoupledFactor, IsNotAnalysedAgainForAsManyCouplingsWhereItDoesNotPay) {
    const BlockMatrix matrix = joined_at_random(1000);
    CoupledFactor factor;
    for (int step = 0; step < 8; ++step)
        EXPECT_FALSE(factor.pays(matrix, couplings(50 * step, 30 + 2 * step)));
    EXPECT_EQ(factor.analyses(), 1);
    EXPECT_FALSE(factor.pays(matrix, couplings(450, 20)));
    EXPECT_EQ(factor.analyses(), 2);
}

// Springs come and go; those that the pattern has not are left to iterations.
TEST(CoupledFactor, SolvesByAPatternThatLags) {
    SprungBars bars;
    CoupledFactor factor;
    bars.tie(0, 40);
    solve(factor, bars);
    for (const int shift : {1, 2}) {
        bars.tie(shift, 40 + shift);
        const Solved solved = solve(factor, bars, 1e-3);
        expect_solved(bars, solved, 1e-3);
        EXPECT_GT(solved.report.iterations, 0);
    }
    EXPECT_EQ(factor.analyses(), 1);
    bars.tie(0, 30);
    expect_solved(bars, solve(factor, bars), 1e-6);
    EXPECT_EQ(factor.analyses(), 1);
}

// Of such a spring the matrix may hold all blocks or none: with some of them it is indefinite.
TEST(CoupledFactor, SolvesWhereThePatternHasAPartOfAPair) {
    SprungBars bars;
    CoupledFactor factor;
    bars.tie(0, 10);
    solve(factor, bars);
    bars.tie(0, 10, 2);
    expect_solved(bars, solve(factor, bars), 1e-6);
    EXPECT_EQ(factor.analyses(), 1);
}

TEST(CoupledFactor, IsAnalysedAnewOnceIterationsHaveCostAsMuch) {
    SprungBars bars;
    CoupledFactor factor;
    bars.tie(0, 40);
    solve(factor, bars);
    bars.tie(1, 41);
    int solves = 0;
    while (factor.analyses() == 1 && ++solves < 30) solve(factor, bars);
    EXPECT_GT(solves, 1);
    EXPECT_LT(solves, 15);
    EXPECT_LE(solve(factor, bars, 1e-2).report.iterations, 2);
    // So many at once that iterations would cost more.
    bars.tie(60, 100);
    solve(factor, bars);
    EXPECT_EQ(factor.analyses(), 3);
}

// Only these rows of the matrix differ from the last; couplings change besides.
TEST(CoupledFactor, NeedsButTheChangedRowsOfTheMatrix) {
    SprungBars bars;
    CoupledFactor factor, whole;
    bars.tie(0, 40);
    solve(factor, bars);
    solve(whole, bars);
    // What lies within one node has changed of the springs that are gone, too.
    std::vector<int> changed{bars.nodes - 1};
    for (std::size_t k = 30; k < 40; ++k)
        for (const int node : bars.springs[k].first.nodes) changed.push_back(node);
    bars.unsprung.block[bars.unsprung.diagonal[changed[0]]].diagonal().array() += 5.0;
    bars.tie(0, 30);
    const Solved by_rows = solve(factor, bars, 1e-6, changed);
    expect_solved(bars, by_rows, 1e-6);
    EXPECT_EQ(by_rows.x, solve(whole, bars).x);
}

TEST(CoupledFactor, RestoredGoesOnToTheLastBitForAnyNumberOfThreads) {
    SprungBars bars;
    std::vector<std::vector<Vec3>> ends;
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        CoupledFactor factor, restored;
        bars.tie(0, 40);
        solve(factor, bars);
        bars.tie(1, 41);
        solve(factor, bars);
        const CoupledMemory memory = factor.memory();
        restored.restore(bars.matrix, memory);
        EXPECT_EQ(restored.memory(), memory);
        for (int k = 0; k < 8; ++k) {
            bars.tie(k, 42 + k % 3);
            const Solved first = solve(factor, bars), second = solve(restored, bars);
            EXPECT_EQ(first.x, second.x) << k;
            EXPECT_EQ(first.report.iterations, second.report.iterations) << k;
            if (k == 7) ends.push_back(first.x);
        }
        EXPECT_EQ(factor.analyses(), restored.analyses());
    }
    EXPECT_EQ(ends[0], ends[1]);
    EXPECT_EQ(ends[0], ends[2]);
}

TEST(CoupledFactor, EndsWhereAStopWasAskedFor) {
    SprungBars bars;
    CoupledFactor factor;
    bars.tie(0, 40);
    std::stop_source stop;
    factor.heed(stop.get_token());
    solve(factor, bars);
    stop.request_stop();
    EXPECT_THROW(solve(factor, bars), Cancelled);
}

TEST(CoupledFactor, RefusesAMemoryThatCannotBeOfTheMatrix) {
    SprungBars bars;
    CoupledFactor factor;
    bars.tie(0, 40);
    solve(factor, bars);
    const CoupledMemory good = factor.memory();
    const auto refuse = [&](auto spoil) {
        CoupledMemory memory = good;
        spoil(memory);
        EXPECT_THROW(factor.restore(bars.matrix, memory), InputError);
        EXPECT_EQ(factor.memory(), good);
    };
    refuse([](CoupledMemory& m) { m.pairs.pop_back(); });
    refuse([](CoupledMemory& m) { std::swap(m.pairs[0], m.pairs[1]); });
    refuse([](CoupledMemory& m) { std::swap(m.pairs[1], m.pairs[3]); });
    refuse([&](CoupledMemory& m) { m.pairs.back() = bars.nodes; });
    refuse([](CoupledMemory& m) { m.pairs[0] = -1; });
    // Two nodes of one element.
    refuse([](CoupledMemory& m) { m.pairs.insert(m.pairs.begin(), {0, 1}); });
    refuse([](CoupledMemory& m) { m.numbers.clear(); });
    refuse([](CoupledMemory& m) { m.numbers.pop_back(); });
    refuse([](CoupledMemory& m) { m.numbers.back() = 0.5; });
    factor.restore(bars.matrix, {});
    EXPECT_TRUE(factor.memory().numbers.empty());
}

}  // namespace
}  // namespace hepatica
