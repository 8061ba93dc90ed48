// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/systems/blob_removal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

using test::straight_link;

// A trunk of 60 mm that divides; on one of its branches hangs something `wide_mm` in radius and
// `long_mm` in length behind a neck of 2 mm.
VesselTree with_end(double wide_mm, double long_mm) {
    VesselGraph graph;
    graph.nodes = {{Vec3(0, 0, 0), 6},
                   {Vec3(60, 0, 0), 5},
                   {Vec3(90, 40, 0), 2},
                   {Vec3(90, -40, 0), 2},
                   {Vec3(90 + long_mm, 40, 0), wide_mm}};
    graph.links = {straight_link(graph, 0, 1, 6, 5), straight_link(graph, 1, 2, 3, 2),
                   straight_link(graph, 1, 3, 3, 2), straight_link(graph, 2, 4, 2, wide_mm)};
    // A spur keeps the node before the wide end.
    graph.nodes.push_back({Vec3(90, 40, 12), 1});
    graph.links.push_back(straight_link(graph, 2, 5, 1.5, 1));
    return directed(graph);
}

RemovedPieces removed_from(const VesselTree& tree, VesselGraph& graph,
                           const std::vector<VesselSeed>& seeds = {}) {
    graph = to_graph(tree);
    return remove_blobs(tree, seeds, graph);
}

TEST(BlobRemoval, RemovesWhatIsWideAndShortBehindANeck) {
    VesselGraph graph;
    const RemovedPieces removed = removed_from(with_end(6.0, 30.0), graph);
    EXPECT_EQ(removed.count, 1);
    // The neck lies where the branch ends: its spur goes, too.
    EXPECT_NEAR(removed.length_mm, 30.0 + 12.0, 1e-9);
    EXPECT_NEAR(length_mm(directed(graph)), 60 + 50 + 50, 1e-9);
}

// Of a lump the skeleton has many spurs, far longer in all than it is wide.
TEST(BlobRemoval, RemovesALumpWithManySpurs) {
    VesselGraph graph = to_graph(with_end(6.0, 20.0));
    const auto wide = std::ranges::find_if(
        graph.nodes, [](const VesselNode& n) { return n.position_mm == Vec3(110, 40, 0); });
    const int middle = static_cast<int>(wide - graph.nodes.begin());
    for (int i = 0; i < 12; ++i) {
        const double angle = i * 0.5236;
        graph.nodes.push_back({Vec3(112, 40 + 8 * std::cos(angle), 8 * std::sin(angle)), 3});
        graph.links.push_back(
            straight_link(graph, middle, static_cast<int>(graph.nodes.size()) - 1, 5, 3));
    }
    const VesselTree tree = directed(graph);
    const RemovedPieces removed = remove_blobs(tree, {}, graph);
    EXPECT_EQ(removed.count, 1);
    EXPECT_GT(removed.length_mm, 110.0);
}

// `wide_mm` in radius and `long_mm` in length, beside the tree of with_end().
VesselTree with_piece_apart(double wide_mm, double long_mm) {
    VesselGraph graph = to_graph(with_end(1.5, 30.0));
    const int first = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({Vec3(0, 90, 0), wide_mm});
    graph.nodes.push_back({Vec3(long_mm, 90, 0), wide_mm});
    graph.links.push_back(straight_link(graph, first, first + 1, wide_mm, wide_mm));
    return directed(graph);
}

TEST(BlobRemoval, RemovesAWideShortPieceThatStandsApart) {
    VesselGraph graph;
    const VesselTree tree = with_piece_apart(5.0, 28.0);
    const RemovedPieces removed = removed_from(tree, graph);
    EXPECT_EQ(removed.count, 1);
    EXPECT_NEAR(removed.length_mm, 28.0, 1e-9);
    EXPECT_EQ(roots(directed(graph)).size(), 1u);
    const std::vector<VesselSeed> seeds{{Vec3(14, 92, 0), VascularSystem::portal}};
    EXPECT_EQ(removed_from(tree, graph, seeds).count, 0) << "somebody says that it is a vessel";
    for (const auto& [wide, length] : {std::pair(3.9, 20.0), std::pair(5.0, 31.0)})
        EXPECT_EQ(removed_from(with_piece_apart(wide, length), graph).count, 0)
            << wide << ", " << length;
}

// A short trunk that is all there is of its system stays.
TEST(BlobRemoval, KeepsTheOnlyTreeOfASystem) {
    VesselGraph graph;
    graph.nodes = {{Vec3(0, 0, 0), 6}, {Vec3(30, 0, 0), 6}};
    graph.links = {straight_link(graph, 0, 1, 6, 6)};
    EXPECT_EQ(removed_from(directed(graph), graph).count, 0);
}

TEST(BlobRemoval, KeepsVessels) {
    VesselGraph graph;
    for (const auto& [wide, length] : {std::pair(3.9, 20.0),   // not wide
                                       std::pair(6.0, 61.0),   // long: a vessel whose root is wrong
                                       std::pair(1.5, 30.0)})  // tapers
        EXPECT_EQ(removed_from(with_end(wide, length), graph).count, 0) << wide << ", " << length;
    EXPECT_EQ(removed_from(test::forked_tree(), graph).count, 0);
}

TEST(BlobRemoval, KeepsAWideBranchWithoutANeck) {
    VesselGraph graph;
    graph.nodes = {
        {Vec3(0, 0, 0), 6}, {Vec3(60, 0, 0), 5}, {Vec3(80, 20, 0), 4}, {Vec3(80, -20, 0), 4}};
    graph.links = {straight_link(graph, 0, 1, 6, 5), straight_link(graph, 1, 2, 4.6, 4.2),
                   straight_link(graph, 1, 3, 4.1, 5.9)};  // 1.44 times as wide
    EXPECT_EQ(removed_from(directed(graph), graph).count, 0);
}

// The trunk itself is wide and has no neck before it.
TEST(BlobRemoval, KeepsTheRoot) {
    VesselGraph graph;
    graph.nodes = {{Vec3(0, 0, 0), 6}, {Vec3(20, 0, 0), 6}};
    graph.links = {straight_link(graph, 0, 1, 2, 6)};
    EXPECT_EQ(removed_from(directed(graph), graph).count, 0);
}

TEST(BlobRemoval, KeepsWhatASeedLiesIn) {
    VesselGraph graph;
    const VesselTree tree = with_end(6.0, 30.0);
    EXPECT_EQ(removed_from(tree, graph, {{Vec3(118, 44, 0), VascularSystem::portal}}).count, 0);
    EXPECT_EQ(removed_from(tree, graph, {{Vec3(118, 52, 0), VascularSystem::portal}}).count, 1);
}

}  // namespace
}  // namespace hepatica
