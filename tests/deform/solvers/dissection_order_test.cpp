// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/dissection_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "core/deform/solvers/elimination_order.h"
#include "core/deform/solvers/elimination_tree.h"

namespace hepatica {
namespace {

// Of a graph: both directions of every edge, and each node with itself.
BlockMatrix pattern_of(int nodes, const std::vector<std::array<int, 2>>& edges) {
    std::vector<std::vector<int>> rows(static_cast<std::size_t>(nodes));
    for (int i = 0; i < nodes; ++i) rows[i].push_back(i);
    for (const auto& [a, b] : edges) {
        rows[a].push_back(b);
        rows[b].push_back(a);
    }
    BlockMatrix pattern;
    for (std::vector<int>& row : rows) {
        std::ranges::sort(row);
        row.erase(std::unique(row.begin(), row.end()), row.end());
        pattern.column.insert(pattern.column.end(), row.begin(), row.end());
        pattern.row_begin.push_back(static_cast<int>(pattern.column.size()));
    }
    return pattern;
}

// A grid of so many nodes along each axis, neighbours up to two corners apart.
BlockMatrix grid(int nx, int ny, int nz) {
    std::vector<std::array<int, 2>> edges;
    const auto at = [&](int x, int y, int z) { return x + nx * (y + ny * z); };
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                for (int k = 1; k < 8; ++k) {
                    const int u = x + (k & 1), v = y + (k >> 1 & 1), w = z + (k >> 2);
                    if (u < nx && v < ny && w < nz) edges.push_back({at(x, y, z), at(u, v, w)});
                }
    return pattern_of(nx * ny * nz, edges);
}

void expect_permutation(const std::vector<int>& order, int nodes) {
    std::vector<int> sorted = order, all(static_cast<std::size_t>(nodes));
    std::ranges::sort(sorted);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all);
}

TEST(DissectionOrder, NamesEveryNodeOnceOfAnyGraph) {
    std::mt19937 random(3);
    for (const int nodes : {0, 1, 2, 99, 101, 700})
        for (const int degree : {0, 1, 3, 12}) {
            std::vector<std::array<int, 2>> edges;
            for (int k = 0; k < nodes * degree / 2; ++k)
                edges.push_back(
                    {static_cast<int>(random() % nodes), static_cast<int>(random() % nodes)});
            expect_permutation(dissection_order(pattern_of(nodes, edges)), nodes);
        }
    // A star, and a clique: no level parts them.
    std::vector<std::array<int, 2>> star, clique;
    for (int i = 1; i < 150; ++i) {
        star.push_back({0, i});
        for (int j = 0; j < i; ++j) clique.push_back({i, j});
    }
    expect_permutation(dissection_order(pattern_of(150, star)), 150);
    expect_permutation(dissection_order(pattern_of(150, clique)), 150);
}

TEST(DissectionOrder, FillsAThickSlabLessThanMinimumDegree) {
    const BlockMatrix slab = grid(24, 24, 8);
    const double dissected = analyse(slab, dissection_order(slab)).multiplications;
    EXPECT_LT(dissected, 0.8 * analyse(slab, fill_reducing_order(slab)).multiplications);
    // On a rod no order is much better than from end to end.
    const BlockMatrix rod = grid(200, 3, 3);
    EXPECT_LT(analyse(rod, dissection_order(rod)).multiplications,
              3.0 * analyse(rod, fill_reducing_order(rod)).multiplications);
}

}  // namespace
}  // namespace hepatica
