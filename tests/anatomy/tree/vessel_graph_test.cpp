// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/anatomy/tree/vessel_graph.h"

#include <gtest/gtest.h>

#include "tests/anatomy/test_trees.h"

namespace hepatica {
namespace {

using test::forked_graph;

TEST(VesselGraph, ALinkIsSplitWhereItIsToldOfEveryStretch) {
    const VesselGraph whole = forked_graph();
    const VesselLink& link = whole.links[0];
    const double length = length_mm(link);
    for (double along_mm = 0.25; along_mm < length; along_mm += 0.25) {
        VesselGraph graph = whole;
        const int node = split_link(graph, 0, along_mm, 0.0);
        ASSERT_EQ(graph.links.size(), whole.links.size() + 1);
        EXPECT_NEAR(length_mm(graph.links[0]), along_mm, 1e-9);
        EXPECT_NEAR(length_mm(graph.links.back()), length - along_mm, 1e-9);
        EXPECT_NEAR(graph.nodes[node].radius_mm, 4.0 - 0.3 * along_mm / length, 1e-9);
        EXPECT_EQ(graph.links[0].to, node);
        EXPECT_EQ(graph.links.back().from, node);
        EXPECT_EQ(graph.links.back().to, link.to);
    }
}

TEST(VesselGraph, ASplitNearANodeIsThatNode) {
    VesselGraph graph = forked_graph();
    EXPECT_EQ(split_link(graph, 0, 0.9, 1.0), graph.links[0].from);
    EXPECT_EQ(split_link(graph, 0, length_mm(graph.links[0]) - 0.9, 1.0), graph.links[0].to);
    EXPECT_EQ(graph.links.size(), forked_graph().links.size());
}

}  // namespace
}  // namespace hepatica
