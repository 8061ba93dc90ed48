// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/territory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/flow/random_cases.h"

namespace hepatica {
namespace {

using testing_flow::Random;
using testing_flow::random_tree;

FlowSolution perfused(const FlowNetwork& network) {
    FlowConditions conditions;
    conditions.inlets = {{0, InletKind::mass_flow, 1.0, pure(blood())}};
    return solve_flow(network, conditions);
}

TEST(Territory, OfTheRootIsEverything) {
    Random random(41);
    const FlowNetwork network = random_tree(random, 31);
    const Territory all = territory_of(network, perfused(network), {0, 0.0, 0.0});
    for (const double share : all.passed_share) EXPECT_NEAR(share, 1.0, 1e-14);
    EXPECT_EQ(all.outlets.size(), network.outlet_nodes.size());
    EXPECT_NEAR(all.share_of_flow, 1.0, 1e-14);
    EXPECT_NEAR(all.share_of_outflow, 1.0, 1e-14);
    EXPECT_NEAR(all.volume_mm3, volume_mm3(network), 1e-9);
}

TEST(Territory, OfABranchIsItsSubtree) {
    Random random(42);
    const FlowNetwork network = random_tree(random, 63);
    const FlowSolution solution = perfused(network);
    for (int segment = 0; segment < 63; ++segment) {
        const Territory t = territory_of(network, solution, {segment, 0.0, 0.0});
        double volume = 0.0;
        for (int other = 0; other < 63; ++other) {
            bool below = false;
            for (int s = other; s >= 0; s = network.segments[s].proximal_node - 1)
                below |= s == segment;
            ASSERT_NEAR(t.passed_share[other], below ? 1.0 : 0.0, 1e-12);
            if (below) volume += volume_mm3(network, other);
        }
        EXPECT_NEAR(t.volume_mm3, volume, 1e-9);
        EXPECT_NEAR(t.share_of_flow, solution.mass_flow_g_s[segment], 1e-13);
        EXPECT_NEAR(t.share_of_outflow, solution.mass_flow_g_s[segment], 1e-12);
    }
}

// Beyond a closed vessel nothing flows: it is part of no territory.
TEST(Territory, EndsWhereAVesselIsClosed) {
    Random random(43);
    FlowNetwork network = random_tree(random, 7);
    set_open(network, 1, false);
    const Territory t = territory_of(network, perfused(network), {0, 0.0, 0.0});
    double volume = 0.0;
    for (const int open : {0, 2, 5, 6}) {
        EXPECT_NEAR(t.passed_share[open], 1.0, 1e-12) << open;
        volume += volume_mm3(network, open);
    }
    for (const int closed : {1, 3, 4}) EXPECT_EQ(t.passed_share[closed], 0.0) << closed;
    EXPECT_NEAR(t.volume_mm3, volume, 1e-9);
    ASSERT_EQ(t.outlets.size(), 2u);
    EXPECT_NEAR(t.share_of_outflow, 1.0, 1e-12);
}

// Against the flow of a vessel that is perfused from its far end, what lies upstream has not
// passed.
TEST(Territory, FollowsTheFlowWhereItRunsBackwards) {
    FlowNetwork network;
    network.node_count = 3;
    network.root_nodes = {0};
    network.outlet_nodes = {0};
    network.cones = {{1, 1, 10}, {1, 1, 20}};
    network.segments = {{0, 1, 0, 1, 0}, {1, 2, 1, 1, 1}};
    FlowConditions conditions;
    conditions.inlets = {{2, InletKind::mass_flow, 1.0, pure(blood())}};
    const Territory t = territory_of(network, solve_flow(network, conditions), {1, 5.0, 0.0});
    EXPECT_EQ(t.segment, 1);
    EXPECT_EQ(t.begins_mm, 5.0);
    EXPECT_NEAR(t.passed_share[0], 1.0, 1e-12);
    EXPECT_NEAR(t.volume_mm3, 15.0 * 3.14159265358979323846, 1e-9);  // 5 mm of it and all of 0
    EXPECT_NEAR(t.share_of_flow, 1.0, 1e-12);
    EXPECT_NEAR(t.flow_mm3_s, 1.0 / 1.06e-3, 1e-9);
}

// A ring: half the flow goes each way; where they meet, half of the blood has passed the point.
TEST(Territory, IsDilutedWhereALoopCloses) {
    FlowNetwork network;
    network.node_count = 4;
    network.root_nodes = {0};
    network.outlet_nodes = {3};
    network.cones = {{2, 2, 1}, {1, 1, 10}, {1, 1, 10}, {2, 2, 10}};
    network.segments = {{0, 1, 0, 1, 0}, {1, 2, 1, 1, 1}, {1, 2, 2, 1, 2}, {2, 3, 3, 1, 3}};
    const Territory t = territory_of(network, perfused(network), {1, 4.0, 0.0});
    EXPECT_NEAR(t.passed_share[3], 0.5, 1e-12);
    EXPECT_EQ(t.passed_share[2], 0.0);
    EXPECT_NEAR(t.share_of_outflow, 0.5, 1e-12);
    const double pi = 3.14159265358979323846;
    EXPECT_NEAR(t.volume_mm3, 6 * pi + 0.5 * 40 * pi, 1e-10);
}

}  // namespace
}  // namespace hepatica
