// SPDX-License-Identifier: GPL-3.0-or-later
// Nested dissection: every node once, and few levels however long a chain is.
#include "gpu/step/bisection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

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

TEST(BisectingCuts, NameEveryNodeOnce) {
    for (const CoarseSkeleton& skeleton :
         {chain(1), chain(2), chain(57), test::make_brick_tree(4, 4.0, 2.0).skeleton}) {
        std::vector<int> nodes, all(static_cast<std::size_t>(skeleton.size()));
        for (const auto& cut : gpu::bisecting_cuts(skeleton)) {
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

// Each cut is solved once, after all that it hears from: in an earlier tier, or in its own block of
// threads in an earlier stage.
TEST(CoarsePlan, OrdersTheStagesOfASolve) {
    const gpu::CoarsePlan plan = gpu::plan_coarse(chain(400), coupled_chain(400));
    ASSERT_GE(plan.tiers.size(), 2u);
    EXPECT_GT(plan.tiers.front().rows(), 10);
    EXPECT_EQ(plan.tiers.back().rows(), 1);
    using Place = std::array<int, 3>;  // tier, row, stage
    std::vector<Place> places(static_cast<std::size_t>(plan.cuts()), Place{-1, -1, -1});
    for (std::size_t t = 0; t < plan.tiers.size(); ++t) {
        const gpu::CutStages& tier = plan.tiers[t];
        for (int row = 0; row < tier.rows(); ++row)
            for (int s = 0; s < tier.stages; ++s) {
                const int at = row * (tier.stages + 1) + s;
                for (int cut = tier.begin[at]; cut < tier.begin[at + 1]; ++cut) {
                    EXPECT_EQ(places[cut][0], -1);
                    places[cut] = {static_cast<int>(t), row, s};
                }
            }
    }
    for (int k = 0; k < plan.cuts(); ++k) {
        ASSERT_GE(places[k][0], 0);
        for (int b = plan.column_begin[k] + 1; b < plan.column_begin[k + 1]; ++b) {
            const Place &low = places[k], &high = places[plan.row[b]];
            EXPECT_TRUE(low[0] < high[0] ||
                        (low[0] == high[0] && low[1] == high[1] && low[2] < high[2]));
        }
    }
}

}  // namespace
}  // namespace hepatica
