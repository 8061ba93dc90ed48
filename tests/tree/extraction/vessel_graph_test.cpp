// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/vessel_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>
#include <vector>

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

// At a node with links of three systems the first one keeps it, wherever the others are named.
TEST(VesselGraph, SystemsGetCopiesOfANodeThatTheyShare) {
    VesselGraph graph = forked_graph();
    const int nodes = static_cast<int>(graph.nodes.size());
    graph.links[0].system = graph.links[3].system = graph.links[4].system = VascularSystem::portal;
    graph.links[1].system = VascularSystem::hepatic;
    graph.links[2].system = VascularSystem::artery;
    const VesselGraph before = graph;
    const SystemNodes node_of = separate_systems(graph);
    ASSERT_EQ(std::ssize(graph.nodes), nodes + 3);  // two at node 1, one at node 3
    EXPECT_EQ(node_of.at({1, VascularSystem::portal}), 1);
    EXPECT_EQ(node_of.at({1, VascularSystem::hepatic}), nodes);
    EXPECT_EQ(node_of.at({1, VascularSystem::artery}), nodes + 1);
    EXPECT_EQ(node_of.at({3, VascularSystem::artery}), 3);
    EXPECT_EQ(node_of.at({3, VascularSystem::portal}), nodes + 2);
    EXPECT_FALSE(node_of.contains({0, VascularSystem::hepatic}));
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        const VesselLink &link = graph.links[i], &was = before.links[i];
        EXPECT_EQ(link.from, node_of.at({was.from, link.system})) << "link " << i;
        EXPECT_EQ(link.to, node_of.at({was.to, link.system})) << "link " << i;
        EXPECT_EQ(graph.nodes[link.from].position_mm, link.points_mm.front()) << "link " << i;
    }
}

TEST(VesselGraph, ItsSegmentsAreItsLinks) {
    const VesselGraph graph = forked_graph();
    const std::vector<VesselSegment> segments = segments_of(graph);
    ASSERT_EQ(segments.size(), graph.links.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        EXPECT_EQ(segments[i].points_mm, graph.links[i].points_mm);
        EXPECT_EQ(segments[i].radii_mm, graph.links[i].radii_mm);
    }
}

TEST(VesselTree, WhatHangsOnASegmentIsDownstreamOfIt) {
    const VesselTree tree = directed(forked_graph());
    const std::vector<std::vector<int>> child_ids = children(tree);
    ASSERT_EQ(tree.segments.size(), 5u);
    for (int s = 0; s < 5; ++s) {
        const std::vector<std::uint8_t> marked = downstream_of(tree, s);
        const bool fork = child_ids[s].size() == 2;
        EXPECT_EQ(std::ranges::count(marked, 1), s == 0 ? 5 : fork ? 3 : 1) << s;
        EXPECT_EQ(marked[s], 1) << s;
        for (const int child : child_ids[s]) EXPECT_EQ(marked[child], 1) << s;
    }
}

TEST(VesselTree, OrdersRiseWhereTwoBranchesOfTheHighestMeet) {
    VesselTree tree = directed(forked_graph());
    const auto orders = [&] {
        for (VesselSegment& segment : tree.segments) segment.strahler_order = 9;
        set_strahler_orders(tree);
        std::vector<int> found;
        for (const VesselSegment& segment : tree.segments) found.push_back(segment.strahler_order);
        return found;
    };
    const std::vector<std::vector<int>> child_ids = children(tree);
    int second_fork = 0;
    for (const int child : child_ids[0])
        if (!child_ids[child].empty()) second_fork = child;
    std::vector<int> expected(5, 1);
    expected[0] = expected[second_fork] = 2;
    EXPECT_EQ(orders(), expected);
    // A segment that closes a loop is no branch: the second fork is none any more.
    tree.segments[child_ids[second_fork][1]].closes_loop = true;
    expected[second_fork] = 1;
    EXPECT_EQ(orders(), expected) << "two branches of order 1 meet at the first one";
}

}  // namespace
}  // namespace hepatica
