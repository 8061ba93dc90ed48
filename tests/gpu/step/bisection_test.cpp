// SPDX-License-Identifier: GPL-3.0-or-later
// Nested dissection: every node once, and few levels however long a chain is.
#include "gpu/step/bisection.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>

#include "gpu/step/coarse_plan.h"
#include "tests/deform/support/test_bodies.h"

namespace hepatica {
namespace {

CoarseSkeleton chain(int nodes) {
    CoarseSkeleton skeleton;
    for (int i = 0; i < nodes; ++i) {
        skeleton.positions_mm.push_back({2.0 * i, 0.0, 0.0});
        skeleton.parent.push_back(i - 1);
        skeleton.radii_mm.push_back(2.0);
    }
    return skeleton;
}

// Nodes that share elements with the next two on either side, as in a vessel.
BlockMatrix coupled_chain(int nodes) {
    BlockMatrix coarse;
    for (int i = 0; i < 4 * nodes; ++i) {
        for (int j = 0; j < 4 * nodes; ++j)
            if (std::abs(i / 4 - j / 4) <= 2) coarse.column.push_back(j);
        coarse.row_begin.push_back(static_cast<int>(coarse.column.size()));
    }
    return coarse;
}

// Nodes that share elements with their parents and children alone.
gpu::Couplings coupled_in_tree(const CoarseSkeleton& skeleton) {
    gpu::Couplings coupled(static_cast<std::size_t>(skeleton.size()));
    for (int n = 0; n < skeleton.size(); ++n)
        if (const int parent = skeleton.parent[n]; parent >= 0) {
            coupled[n].push_back(parent);
            coupled[parent].push_back(n);
        }
    return coupled;
}

// A random tree whose nodes are coupled with those up to `reach` steps away, and so many others.
struct RandomTree {
    CoarseSkeleton skeleton;
    gpu::Couplings coupled;

    RandomTree(int nodes, int reach, int touching, std::mt19937& random)
        : coupled(static_cast<std::size_t>(nodes)) {
        for (int n = 0; n < nodes; ++n) {
            const int back = 1 + static_cast<int>(random() % 8u == 0 ? random() % 20u : 0u);
            skeleton.positions_mm.emplace_back(n, 0.0, 0.0);
            skeleton.radii_mm.push_back(1.0);
            skeleton.parent.push_back(std::max(n - back, n == 0 ? -1 : 0));
            for (int above = skeleton.parent[n], k = 0; above >= 0 && k < reach;
                 above = skeleton.parent[above], ++k)
                couple(n, above);
        }
        for (int k = 0; k < touching; ++k)
            couple(static_cast<int>(random() % static_cast<unsigned>(nodes)),
                   static_cast<int>(random() % static_cast<unsigned>(nodes)));
    }
    void couple(int a, int b) {
        coupled[a].push_back(b);
        coupled[b].push_back(a);
    }
    // As plan_coarse wants it: four rows a node.
    BlockMatrix pattern() const {
        BlockMatrix coarse;
        coarse.row_begin = {0};
        for (std::size_t n = 0; n < coupled.size(); ++n) {
            std::vector<int> others = coupled[n];
            others.push_back(static_cast<int>(n));
            std::ranges::sort(others);
            others.erase(std::ranges::unique(others).begin(), others.end());
            for (int vector = 0; vector < 4; ++vector) {
                for (const int other : others)
                    for (int c = 0; c < 4; ++c) coarse.column.push_back(4 * other + c);
                coarse.row_begin.push_back(static_cast<int>(coarse.column.size()));
            }
        }
        return coarse;
    }
};

// Branches that touch and nodes that reach over their neighbours, as on a patient: the plan stays
// shallow, where cuts that only follow the tree made hundreds of levels.
TEST(CoarsePlan, OfAPatientsTreeIsShallow) {
    std::mt19937 random(20261127);
    for (int trial = 0; trial < 10; ++trial) {
        const RandomTree tree(600, 3, 20, random);
        const gpu::CoarsePlan plan = gpu::plan_coarse(tree.skeleton, tree.pattern());
        EXPECT_LE(plan.levels(), 26) << "trial " << trial;
        // 5.38 to 5.64 of them; the larger border of two in place of the smaller makes 5.77 or
        // more.
        EXPECT_LT(plan.blocks(), 5.7 * plan.cuts()) << "trial " << trial;
        std::vector<int> slots = plan.slot_of_node;
        std::ranges::sort(slots);
        EXPECT_TRUE(std::ranges::adjacent_find(slots) == slots.end());
    }
}

TEST(BisectingCuts, NameEveryNodeOnce) {
    for (const CoarseSkeleton& skeleton :
         {chain(1), chain(2), chain(57), test::make_brick_tree(4, 4.0, 2.0).skeleton}) {
        std::vector<int> nodes, all(static_cast<std::size_t>(skeleton.size()));
        for (const auto& cut : gpu::bisecting_cuts(skeleton, coupled_in_tree(skeleton))) {
            EXPECT_GE(cut[0], 0);
            for (const int node : cut)
                if (node >= 0) nodes.push_back(node);
        }
        std::iota(all.begin(), all.end(), 0);
        std::ranges::sort(nodes);
        EXPECT_EQ(nodes, all);
    }
}

TEST(CoarsePlan, MakesLongChainsShallow) {
    const gpu::CoarsePlan plan = gpu::plan_coarse(chain(400), coupled_chain(400));
    EXPECT_LE(plan.levels(), 9);  // 200 from one end to the other
    std::vector<int> slots = plan.slot_of_node;
    std::ranges::sort(slots);
    EXPECT_TRUE(std::ranges::adjacent_find(slots) == slots.end());
    EXPECT_EQ(slots.size(), 400u);
}

// N with a random number for each block, in full.
Eigen::MatrixXd random_factor(const gpu::CoarsePlan& plan, std::vector<double>& of_block) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    Eigen::MatrixXd factor = Eigen::MatrixXd::Identity(plan.cuts(), plan.cuts());
    for (int p = 0; p < plan.cuts(); ++p)
        for (int b = plan.column_begin[p]; b < plan.column_begin[p + 1]; ++b) {
            of_block.push_back(any(random));
            if (plan.row[b] != p) factor(plan.row[b], p) = of_block[b];
        }
    return factor;
}

// The lists of N^-1, followed level by level with a number for each block, give the inverse.
TEST(CoarsePlan, InvertsTheFactor) {
    const CoarseSkeleton tree = test::make_brick_tree(4, 4.0, 2.0).skeleton;
    for (const CoarseSkeleton& skeleton : {chain(1), chain(2), chain(400), tree}) {
        const gpu::CoarsePlan plan = gpu::plan_coarse(skeleton, coupled_chain(skeleton.size()));
        const gpu::InversePlan& inverse = plan.inverse;
        std::vector<double> of_block;
        const Eigen::MatrixXd factor = random_factor(plan, of_block);
        std::vector<double> found(inverse.column.size(), NAN);
        for (const int block : inverse.by_level) {
            double sum = 0.0;
            for (int k = inverse.product_begin[block]; k < inverse.product_begin[block + 1]; ++k) {
                const auto [left, right] = inverse.product[k];
                sum -= (left < 0 ? 1.0 : found[left]) * of_block[right];
            }
            found[block] = sum;
        }
        Eigen::MatrixXd by_rows = Eigen::MatrixXd::Identity(plan.cuts(), plan.cuts());
        Eigen::MatrixXd by_columns = by_rows;
        for (int i = 0; i < plan.cuts(); ++i)
            for (int k = inverse.chunk_begin[inverse.first_chunk[i]];
                 k < inverse.chunk_begin[inverse.first_chunk[i + 1]]; ++k)
                by_rows(i, inverse.column[k]) = found[k];
        for (int p = 0; p < plan.cuts(); ++p)
            for (int k = inverse.above_begin[p]; k < inverse.above_begin[p + 1]; ++k)
                by_columns(inverse.above[k].cut, p) = found[inverse.above[k].block];
        const Eigen::MatrixXd exact = factor.inverse();
        EXPECT_LT((by_rows - exact).norm(), 1e-12 * exact.norm());
        EXPECT_EQ((by_columns - by_rows).norm(), 0.0);
    }
}

// A level of N^-1 hears of earlier ones alone.
TEST(CoarsePlan, InvertsFromTheHighestLevelDown) {
    const gpu::CoarsePlan plan = gpu::plan_coarse(chain(400), coupled_chain(400));
    const gpu::InversePlan& inverse = plan.inverse;
    std::vector<int> level(inverse.column.size());
    for (std::size_t l = 0; l + 1 < inverse.level_begin.size(); ++l)
        for (int k = inverse.level_begin[l]; k < inverse.level_begin[l + 1]; ++k)
            level[inverse.by_level[k]] = static_cast<int>(l);
    int products = 0;
    for (std::size_t block = 0; block < level.size(); ++block)
        for (int k = inverse.product_begin[block]; k < inverse.product_begin[block + 1]; ++k) {
            if (inverse.product[k].inverse < 0) continue;
            EXPECT_LT(level[inverse.product[k].inverse], level[block]);
            ++products;
        }
    EXPECT_GT(products, 400);
}

}  // namespace
}  // namespace hepatica
