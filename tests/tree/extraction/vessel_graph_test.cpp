// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/vessel_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

using test::forked_graph;
using test::straight_link;

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

TEST(VesselGraph, ComponentsAreNumberedByTheirFirstNode) {
    VesselGraph graph;
    for (int n = 0; n < 7; ++n) graph.nodes.push_back({Vec3(10 * n, 0, 0), 1.0});
    graph.links = {straight_link(graph, 6, 1, 1, 1), straight_link(graph, 5, 2, 1, 1),
                   straight_link(graph, 2, 0, 1, 1)};
    EXPECT_EQ(component_of_nodes(graph), (std::vector<int>{0, 1, 0, 2, 3, 0, 1}));
}

// A spanning forest takes one link less than nodes of each component; whatever is beyond closes a
// loop, however nodes and links are numbered.
TEST(VesselGraph, ATreeLeavesTheLinksThatCloseLoops) {
    std::mt19937 chance(9);
    for (int trial = 0; trial < 400; ++trial) {
        VesselGraph graph;
        const int nodes = 2 + static_cast<int>(chance() % 5);
        for (int n = 0; n < nodes; ++n) graph.nodes.push_back({Vec3(10.0 * n, n % 3, 0), 1.0});
        for (int l = 0, links = static_cast<int>(chance() % 8); l < links; ++l) {
            const int from = static_cast<int>(chance() % graph.nodes.size());
            const int to = static_cast<int>(chance() % graph.nodes.size());
            if (from != to) graph.links.push_back(straight_link(graph, from, to, 1, 1));
        }
        const std::vector<int> component = component_of_nodes(graph);
        const int components = *std::ranges::max_element(component) + 1;
        const auto spanning = static_cast<std::size_t>(nodes - components);
        const VesselTree tree = directed(graph);
        const auto closing = std::ranges::count_if(tree.segments, &VesselSegment::closes_loop);
        EXPECT_EQ(tree.segments.size(), graph.links.size());
        EXPECT_EQ(static_cast<std::size_t>(closing), graph.links.size() - spanning) << trial;
    }
}

// Systems in ascending order, and of one system the longest piece first, however they come in.
TEST(VesselGraph, ATreesComponentsStandBySystemThenByLength) {
    struct Piece {
        VascularSystem system;
        double length_mm;
    };
    const std::vector<Piece> sorted{
        {VascularSystem::portal, 9.0},   {VascularSystem::portal, 4.0},
        {VascularSystem::hepatic, 30.0}, {VascularSystem::hepatic, 20.0},
        {VascularSystem::hepatic, 2.0},  {VascularSystem::unknown, 50.0}};
    std::vector<int> order{0, 1, 2, 3, 4, 5};
    do {
        VesselGraph graph;
        for (const int i : order) {
            const int first = static_cast<int>(graph.nodes.size());
            graph.nodes.push_back({Vec3(0, 20 * i, 0), 1.0});
            graph.nodes.push_back({Vec3(sorted[i].length_mm, 20 * i, 0), 1.0});
            graph.links.push_back(straight_link(graph, first, first + 1, 1, 1, sorted[i].system));
        }
        const VesselTree tree = directed(graph);
        ASSERT_EQ(tree.segments.size(), sorted.size());
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            EXPECT_EQ(tree.segments[i].system, sorted[i].system);
            EXPECT_NEAR(length_mm(tree.segments[i]), sorted[i].length_mm, 1e-9);
        }
    } while (std::ranges::next_permutation(order).found);
}

// A component is as long as all of its links, not as its longest.
TEST(VesselGraph, TheLengthOfAComponentIsThatOfAllItsLinks) {
    VesselGraph graph = forked_graph();  // 84 mm in five links
    const int first = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({Vec3(0, 0, 100), 1.0});
    graph.nodes.push_back({Vec3(60, 0, 100), 1.0});
    graph.links.insert(graph.links.begin(), straight_link(graph, first, first + 1, 1, 1));
    const VesselTree tree = directed(graph);
    EXPECT_EQ(tree.segments.front().points_mm.front(), Vec3(0, 0, 0));
    EXPECT_EQ(tree.segments.back().points_mm.front().z(), 100.0);
}

}  // namespace
}  // namespace hepatica
