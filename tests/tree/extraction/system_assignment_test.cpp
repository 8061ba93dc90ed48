// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/system_assignment.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/test_trees.h"

namespace hepatica {

using namespace test;

//   two forks that touch at their thin ends:   0 ==> 1 --> 2 <-- 3 <== 4
TEST(SystemAssignment, TouchingSystemsPartAtTheNarrowestLink) {
    VesselGraph graph;
    for (const double x : {0.0, 20.0, 40.0, 60.0, 80.0, 30.0})
        graph.nodes.push_back({Vec3(x, x == 30.0 ? 15.0 : 0.0, 0), 1.0});
    graph.links = {straight_link(graph, 0, 1, 5.0, 4.0), straight_link(graph, 1, 2, 2.0, 1.0),
                   straight_link(graph, 2, 3, 1.5, 2.5), straight_link(graph, 3, 4, 3.0, 4.0),
                   straight_link(graph, 1, 5, 3.0, 2.0)};
    assign_systems(graph, {{Vec3(2, 1, 0), 7}, {Vec3(79, 0, 1), 9}});
    EXPECT_EQ(graph.links[0].system, 7);
    EXPECT_EQ(graph.links[4].system, 7);
    EXPECT_EQ(graph.links[1].system, 7);
    EXPECT_EQ(graph.links[2].system, 9);
    EXPECT_EQ(graph.links[3].system, 9);
    const VesselTree tree = directed(graph);
    validate(tree);
    EXPECT_EQ(roots(tree).size(), 2u);
}

TEST(SystemAssignment, TwoSeedsOnOneLinkPartItAtItsNarrowestPoint) {
    VesselGraph graph;
    graph.nodes = {{Vec3(0, 0, 0), 3.0}, {Vec3(40, 0, 0), 3.0}};
    VesselLink link = straight_link(graph, 0, 1, 3.0, 3.0);
    link.radii_mm[5] = 0.7;
    graph.links = {link};
    assign_systems(graph, {{Vec3(1, 0, 0), 0}, {Vec3(38, 0, 0), 1}});
    ASSERT_EQ(graph.links.size(), 2u);
    EXPECT_EQ(graph.links[0].system, 0);
    EXPECT_EQ(graph.links[1].system, 1);
    EXPECT_DOUBLE_EQ(graph.links[0].points_mm.back().x(), 25.0);
}

TEST(SystemAssignment, PiecesWithoutSeedJoinTheNearestSystem) {
    VesselGraph graph;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(0, 50, 0), Vec3(20, 50, 0),
                          Vec3(0, 40, 0), Vec3(20, 42, 0)})
        graph.nodes.push_back({p, 1.0});
    graph.links = {straight_link(graph, 0, 1, 2, 2), straight_link(graph, 2, 3, 2, 2),
                   straight_link(graph, 4, 5, 2, 2)};
    assign_systems(graph, {{Vec3(1, 0, 0), 3}, {Vec3(1, 50, 0), 4}});
    EXPECT_EQ(graph.links[2].system, 4);
}

//   one link whose right half lies in voxels of another system
TEST(SystemAssignment, LabelsOfTheMaskPartALink) {
    Mask labels;
    labels.grid.dims = {41, 5, 5};
    labels.grid.origin_mm = Vec3(0, -2, -2);
    labels.voxels.resize(labels.grid.count());
    for (std::size_t i = 0; i < labels.voxels.size(); ++i)
        labels.voxels[i] = labels.grid.index_of(i)[0] < 22 ? 1 : 2;
    VesselGraph graph;
    graph.nodes = {{Vec3(0, 0, 0), 2.0}, {Vec3(40, 0, 0), 2.0}};
    graph.links = {straight_link(graph, 0, 1, 2.0, 2.0)};
    EXPECT_TRUE(assign_systems_by_labels(graph, labels));
    ASSERT_EQ(graph.links.size(), 2u);
    EXPECT_EQ(graph.links[0].system, 1);
    EXPECT_EQ(graph.links[1].system, 2);
    EXPECT_EQ(roots(directed(graph)).size(), 2u);
    for (auto& voxel : labels.voxels) voxel = 1;
    EXPECT_FALSE(assign_systems_by_labels(graph, labels));
}

// Whatever the seeds, every link gets one of their systems and the directed tree is valid.
TEST(SystemAssignment, RandomSeedsAlwaysGiveAValidForest) {
    std::mt19937_64 random(1);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
    for (int trial = 0; trial < 500; ++trial) {
        VesselGraph graph = forked_graph();
        std::vector<SystemSeed> seeds;
        for (std::size_t s = 0; s <= random() % 4; ++s)
            seeds.push_back({Vec3(40 * uniform() - 15, 55 * uniform(), 10 * uniform() - 5),
                             static_cast<int>(random() % 3)});
        assign_systems(graph, seeds);
        for (const VesselLink& link : graph.links)
            EXPECT_TRUE(std::ranges::any_of(
                seeds, [&](const SystemSeed& seed) { return seed.system == link.system; }));
        const VesselTree tree = directed(graph);
        validate(tree);
        EXPECT_NEAR(length_mm(tree), length_mm(forked_tree()), 1e-9);
    }
}

}  // namespace hepatica
