// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/system_summary.h"

#include <gtest/gtest.h>

#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

// Three separate links of 10, 30 and 20 mm and a loop of two links.
TEST(SystemSummary, SumsLengthRootsConfidenceAndLoopsOfEachSystem) {
    VesselGraph graph;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 50, 0), Vec3(30, 50, 0),
                          Vec3(0, 90, 0), Vec3(20, 90, 0)})
        graph.nodes.push_back({p, 1.0});
    graph.links = {test::straight_link(graph, 0, 1, 2, 1, VascularSystem::hepatic),
                   test::straight_link(graph, 2, 3, 3, 1, VascularSystem::hepatic),
                   test::straight_link(graph, 4, 5, 4, 1, VascularSystem::unknown)};
    graph.links[0].system_confidence = 1.0;
    graph.links[1].system_confidence = 0.6;
    graph.links.push_back(graph.links[1]);  // a second way from 2 to 3
    graph.links.back().radii_mm.assign(graph.links.back().points_mm.size(), 0.5);
    const std::vector<SystemSummary> systems = systems_of(directed(graph));
    ASSERT_EQ(systems.size(), 2u);
    EXPECT_EQ(systems[0].system, VascularSystem::hepatic);
    EXPECT_NEAR(systems[0].length_mm, 70.0, 1e-9);
    EXPECT_NEAR(systems[0].confidence, (10.0 * 1.0 + 60.0 * 0.6) / 70.0, 1e-12);
    EXPECT_EQ(systems[0].loops, 1);
    ASSERT_EQ(systems[0].roots.size(), 2u);
    EXPECT_EQ(systems[0].roots[1].at_mm, Vec3(0, 0, 0));
    EXPECT_EQ(systems[0].roots[1].radius_mm, 2.0);
    EXPECT_EQ(systems[1].system, VascularSystem::unknown);
    EXPECT_EQ(systems[1].confidence, 0.0);
    EXPECT_EQ(systems[1].loops, 0);
    ASSERT_EQ(systems[1].roots.size(), 1u);
    EXPECT_EQ(systems[1].roots[0].at_mm, Vec3(0, 90, 0));
    EXPECT_TRUE(systems_of({}).empty());
}

}  // namespace
}  // namespace hepatica
