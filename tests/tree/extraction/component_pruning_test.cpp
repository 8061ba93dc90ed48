// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/component_pruning.h"

#include <gtest/gtest.h>

#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

using test::straight_link;

// Three vessels along x, of 5, 12 and 8 mm.
VesselGraph three_pieces() {
    VesselGraph graph;
    for (const double x : {0.0, 5.0, 100.0, 112.0, 200.0, 208.0})
        graph.nodes.push_back({Vec3(x, 0, 0), 1.0});
    graph.links = {straight_link(graph, 0, 1, 1, 1), straight_link(graph, 2, 3, 1, 1),
                   straight_link(graph, 4, 5, 1, 1)};
    return graph;
}

TEST(ComponentPruning, ShortComponentsGoButTheLongestStays) {
    VesselGraph some = three_pieces(), one = three_pieces();
    const RemovedPieces removed = remove_short_components(some, 6.0);
    EXPECT_EQ(removed.count, 1);
    EXPECT_NEAR(removed.length_mm, 5.0, 1e-9);
    ASSERT_EQ(some.links.size(), 2u);
    EXPECT_NEAR(length_mm(some.links[0]), 12.0, 1e-9);
    EXPECT_NEAR(length_mm(some.links[1]), 8.0, 1e-9);
    const RemovedPieces both = remove_short_components(one, 50.0);
    EXPECT_EQ(both.count, 2);
    EXPECT_NEAR(both.length_mm, 13.0, 1e-9);
    ASSERT_EQ(one.links.size(), 1u);
    EXPECT_NEAR(length_mm(one.links[0]), 12.0, 1e-9);
}

TEST(ComponentPruning, WhatASeedLiesInIsNeverTooShort) {
    VesselGraph graph = three_pieces();
    const RemovedPieces removed = remove_short_components(graph, 50.0, {{Vec3(1, 2, 0)}});
    EXPECT_EQ(removed.count, 1);
    ASSERT_EQ(graph.links.size(), 2u);
    EXPECT_NEAR(length_mm(graph.links[0]), 5.0, 1e-9);
}

TEST(ComponentPruning, AKeptPlaceKeepsOnlyTheVesselThatItBelongsTo) {
    for (const double beside_mm : {3.5, 4.5}) {
        VesselGraph graph = three_pieces();
        const RemovedPieces removed =
            remove_short_components(graph, 50.0, {}, {Vec3(1, beside_mm, 0)});
        EXPECT_EQ(removed.count, beside_mm < 4.0 ? 1 : 2) << "of a radius of 1 mm";
    }
}

TEST(ComponentPruning, OfNothingTakesNothing) {
    VesselGraph graph;
    EXPECT_EQ(remove_short_components(graph, 6.0, {{Vec3(0, 0, 0)}}).count, 0);
}

}  // namespace
}  // namespace hepatica
