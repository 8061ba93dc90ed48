// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/system_assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <utility>

#include "tests/support/test_trees.h"

namespace hepatica {

using namespace test;
using enum VascularSystem;

// Voxels of 1 mm around the graphs below, each with the system that `at` gives its place.
Mask systems_by(const std::function<VascularSystem(const Vec3&)>& at) {
    Grid grid;
    grid.dims = {110, 75, 40};
    grid.origin_mm = Vec3(-20, -10, -20);
    Mask mask(grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        mask.voxels[i] = static_cast<std::uint8_t>(at(grid.to_mm(x, y, z)));
    }
    return mask;
}

//   two forks that touch at their thin ends:   0 ==> 1 --> 2 <-- 3 <== 4
TEST(SystemAssignment, TouchingSystemsPartAtTheNarrowestLink) {
    VesselGraph graph;
    for (const double x : {0.0, 20.0, 40.0, 60.0, 80.0, 30.0})
        graph.nodes.push_back({Vec3(x, x == 30.0 ? 15.0 : 0.0, 0), 1.0});
    graph.links = {straight_link(graph, 0, 1, 5.0, 4.0), straight_link(graph, 1, 2, 2.0, 1.0),
                   straight_link(graph, 2, 3, 1.5, 2.5), straight_link(graph, 3, 4, 3.0, 4.0),
                   straight_link(graph, 1, 5, 3.0, 2.0)};
    assign_systems(graph, systems_by([](const Vec3& p) {
                       if (p.y() < 5 && p.x() < 19) return portal;
                       return p.y() < 5 && p.x() > 61 ? artery : unknown;
                   }));
    const VesselTree tree = directed(graph);
    validate(tree);
    ASSERT_EQ(roots(tree).size(), 2u);
    for (const VesselSegment& segment : tree.segments) {
        const double farthest =
            std::max(segment.points_mm.front().x(), segment.points_mm.back().x());
        EXPECT_EQ(segment.system, farthest <= 40.0 ? portal : artery);
    }
}

TEST(SystemAssignment, PiecesOfNoSystemStayUnknown) {
    VesselGraph graph;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(0, 50, 0), Vec3(20, 50, 0)})
        graph.nodes.push_back({p, 1.0});
    graph.links = {straight_link(graph, 0, 1, 2, 2), straight_link(graph, 2, 3, 2, 2)};
    assign_systems(graph, systems_by([](const Vec3& p) { return p.y() < 25 ? hepatic : unknown; }));
    EXPECT_EQ(graph.links[0].system, hepatic);
    EXPECT_EQ(graph.links[0].system_confidence, 1.0);
    EXPECT_EQ(graph.links[1].system, unknown);
    EXPECT_EQ(graph.links[1].system_confidence, 0.0);
}

//   one link whose right half lies in voxels of another system
TEST(SystemAssignment, LabelsOfTheMaskPartALink) {
    const auto halved = [](VascularSystem right) {
        return systems_by([=](const Vec3& p) { return p.x() < 22 ? portal : right; });
    };
    VesselGraph whole;
    whole.nodes = {{Vec3(0, 0, 0), 2.0}, {Vec3(40, 0, 0), 2.0}};
    whole.links = {straight_link(whole, 0, 1, 2.0, 2.0)};
    VesselGraph graph = whole;
    assign_systems(graph, halved(hepatic));
    ASSERT_EQ(graph.links.size(), 2u);
    EXPECT_EQ(graph.links[0].system, portal);
    EXPECT_EQ(graph.links[1].system, hepatic);
    EXPECT_EQ(roots(directed(graph)).size(), 2u);
    // What no front reached is no other system: it hangs on the one that it continues.
    graph = whole;
    assign_systems(graph, halved(unknown));
    ASSERT_EQ(graph.links.size(), 1u);
    EXPECT_EQ(graph.links[0].system, portal);
    EXPECT_NEAR(graph.links[0].system_confidence, 0.5, 0.13);
    graph = whole;
    assign_systems(graph, halved(portal));
    ASSERT_EQ(graph.links.size(), 1u);
    EXPECT_EQ(graph.links[0].system_confidence, 1.0);
}

//   one link whose middle lies in no vessel: any place there parts the labels as well
TEST(SystemAssignment, ALinkIsPartedWhereTheFirstLabelEnds) {
    constexpr auto none = static_cast<VascularSystem>(0);
    for (const auto& [left, right] : {std::pair(portal, hepatic), std::pair(hepatic, portal)}) {
        VesselGraph graph;
        graph.nodes = {{Vec3(0, 0, 0), 2.0}, {Vec3(40, 0, 0), 2.0}};
        VesselLink link{0, 1, unknown, 0.0, {}, {}};
        for (int x = 0; x <= 40; ++x) {
            link.points_mm.push_back(Vec3(x, 0, 0));
            link.radii_mm.push_back(2.0);
        }
        graph.links = {link};
        assign_systems(graph, systems_by([&](const Vec3& p) {
                           return p.x() < 14.5 ? left : (p.x() < 25.5 ? none : right);
                       }));
        ASSERT_EQ(graph.links.size(), 2u);
        EXPECT_EQ(graph.links[0].system, left);
        EXPECT_EQ(graph.links[1].system, right);
        EXPECT_EQ(graph.links[0].points_mm.back(), Vec3(15, 0, 0));
        EXPECT_EQ(graph.links[1].points_mm.front(), Vec3(15, 0, 0));
        EXPECT_EQ(graph.links[0].system_confidence, 1.0);
        EXPECT_NEAR(graph.links[1].system_confidence, 15.0 / 26.0, 1e-12);
    }
}

// Whatever the voxels say, the directed tree is valid and as long as before, and every component
// with a known system is known altogether.
TEST(SystemAssignment, RandomVoxelsAlwaysGiveAValidForest) {
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 30; ++trial) {
        VesselGraph graph = forked_graph();
        const int cell_mm = 1 + static_cast<int>(random() % 12);
        const std::uint64_t key = random();
        assign_systems(graph, systems_by([&](const Vec3& p) {
                           std::uint64_t h = key;
                           for (const double c : p)
                               h = (h ^ static_cast<std::uint64_t>(std::lround(c) / cell_mm + 99)) *
                                   0x9e3779b97f4a7c15ULL;
                           return vascular_systems.at((h >> 32) % vascular_systems.size());
                       }));
        const bool any = std::ranges::any_of(
            graph.links, [](const VesselLink& link) { return link.system != unknown; });
        for (const VesselLink& link : graph.links) {
            EXPECT_EQ(link.system != unknown, any);
            EXPECT_GE(link.system_confidence, 0.0);
            EXPECT_LE(link.system_confidence, 1.0);
        }
        const VesselTree tree = directed(graph);
        validate(tree);
        EXPECT_NEAR(length_mm(tree), length_mm(forked_tree()), 1e-9);
    }
}

}  // namespace hepatica
