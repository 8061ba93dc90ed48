// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/spur_pruning.h"

#include <gtest/gtest.h>

#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

using test::straight_link;

constexpr double wall_mm = 4.0;  // radius of the vessel that the spurs leave

// A vessel along x with twigs at its middle that reach `beyond_mm` past its wall.
VesselGraph with_twigs(const std::vector<double>& beyond_mm) {
    VesselGraph graph;
    graph.nodes = {{Vec3(-40, 0, 0), wall_mm}, {Vec3(0, 0, 0), wall_mm}, {Vec3(40, 0, 0), wall_mm}};
    graph.links = {straight_link(graph, 0, 1, wall_mm, wall_mm),
                   straight_link(graph, 1, 2, wall_mm, wall_mm)};
    for (std::size_t i = 0; i < beyond_mm.size(); ++i) {
        const Vec3 way = i % 2 == 0 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
        graph.nodes.push_back({(wall_mm + beyond_mm[i]) * way, 1.0});
        graph.links.push_back(straight_link(graph, 1, static_cast<int>(3 + i), 1.0, 1.0));
    }
    return graph;
}

std::size_t links_left(VesselGraph graph, double spur_radii, double shortest_mm) {
    prune_spurs(graph, spur_radii, shortest_mm);
    return graph.links.size();
}

TEST(SpurPruning, ATwigCountsFromItsShareOfTheRadiusBeyondTheWall) {
    for (const double spur_radii : {0.25, 0.5, 1.0}) {
        const double limit_mm = spur_radii * wall_mm;
        EXPECT_EQ(links_left(with_twigs({limit_mm - 0.01}), spur_radii, 0.0), 1u) << spur_radii;
        EXPECT_EQ(links_left(with_twigs({limit_mm + 0.01}), spur_radii, 0.0), 3u) << spur_radii;
    }
}

TEST(SpurPruning, ATwigCountsFromTheShortestLengthBeyondTheWall) {
    EXPECT_EQ(links_left(with_twigs({2.99}), 0.5, 3.0), 1u);
    EXPECT_EQ(links_left(with_twigs({3.01}), 0.5, 3.0), 3u);
    // The larger of the two limits counts.
    EXPECT_EQ(links_left(with_twigs({3.01}), 0.8, 3.0), 1u);
}

// The vessel's own last stretch may be short too, but it reaches further than the bump beside it.
TEST(SpurPruning, TheWorstOfANodeGoesFirstAndTheOtherThenPassesOn) {
    VesselGraph graph = with_twigs({0.5, 1.5});
    graph.links.erase(graph.links.begin() + 1);  // the vessel ends in its two twigs
    prune_spurs(graph, 0.5, 0.0);
    ASSERT_EQ(graph.links.size(), 1u);
    EXPECT_NEAR(length_mm(graph.links[0]), 40.0 + wall_mm + 1.5, 1e-9);
}

TEST(SpurPruning, AVesselOnItsOwnIsNoSpurHoweverShort) {
    VesselGraph graph;
    graph.nodes = {{Vec3(0, 0, 0), 3.0}, {Vec3(1, 0, 0), 3.0}};
    graph.links = {straight_link(graph, 0, 1, 3.0, 3.0)};
    EXPECT_EQ(links_left(graph, 0.5, 3.0), 1u);
}

// A ring goes where it fits into the lumen, four radii around; a longer one goes around something.
TEST(SpurPruning, OnlyRingsInsideTheLumenGo) {
    for (const double around_mm : {4.0 * wall_mm - 0.1, 4.0 * wall_mm + 0.1}) {
        VesselGraph graph = with_twigs({});
        const double side = around_mm / 4.0;
        graph.links.push_back({1,
                               1,
                               VascularSystem::unknown,
                               0.0,
                               {Vec3(0, 0, 0), Vec3(0, side, 0), Vec3(0, side, side),
                                Vec3(0, 0, side), Vec3(0, 0, 0)},
                               std::vector<double>(5, 1.0)});
        EXPECT_EQ(links_left(graph, 0.5, 0.0), around_mm < 4.0 * wall_mm ? 1u : 3u);
    }
}

}  // namespace
}  // namespace hepatica
