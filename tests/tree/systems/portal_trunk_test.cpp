// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/systems/portal_trunk.h"

#include <gtest/gtest.h>

#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

using test::straight_link;
constexpr VascularSystem portal = VascularSystem::portal, hepatic = VascularSystem::hepatic;

// A portal vein of 5 mm radius from (0, 0, 0) to (60, 0, 0) and a hepatic one at y = 10.
VesselGraph two_veins() {
    VesselGraph graph;
    graph.nodes = {
        {Vec3(0, 0, 0), 5}, {Vec3(60, 0, 0), 5}, {Vec3(0, 10, 0), 2}, {Vec3(60, 10, 0), 2}};
    graph.links = {straight_link(graph, 0, 1, 5, 5, portal),
                   straight_link(graph, 2, 3, 2, 2, hepatic)};
    return graph;
}

double total_mm(const VesselGraph& graph) {
    double sum = 0.0;
    for (const VesselLink& link : graph.links) sum += length_mm(link);
    return sum;
}

TEST(PortalTrunk, BranchesOffWhereThePortalVeinIsNearest) {
    VesselGraph graph = two_veins();
    lead_trunk_to(Vec3(30, 8, 6), graph);
    ASSERT_EQ(graph.links.size(), 4u);
    ASSERT_EQ(graph.nodes.size(), 6u);
    EXPECT_NEAR(total_mm(graph), 130.0, 1.0);
    EXPECT_EQ(graph.nodes.back().position_mm, Vec3(30, 8, 6));
    EXPECT_EQ(graph.nodes.back().radius_mm, 5.0);
    const VesselLink& trunk = graph.links.back();
    EXPECT_EQ(trunk.system, portal);
    EXPECT_LT((trunk.points_mm.front() - Vec3(30, 0, 0)).norm(), 1.0);
    EXPECT_EQ(trunk.points_mm.size(), trunk.radii_mm.size());
}

// 6 mm of the trunk lie beyond the place from which it is led on.
TEST(PortalTrunk, LeavesNoWideEndBesideItsEntry) {
    VesselGraph graph = two_veins();
    lead_trunk_to(Vec3(54, 8, 0), graph);
    EXPECT_NEAR(total_mm(graph), 54.0 + 8.0 + 60.0, 2.0) << "split where its nearest point is";
    graph = two_veins();
    graph.links[0].radii_mm.back() = 2.0;  // as thin as a branch
    lead_trunk_to(Vec3(54, 8, 0), graph);
    EXPECT_NEAR(total_mm(graph), 60.0 + 8.0 + 60.0, 2.0);
}

TEST(PortalTrunk, GoesOnFromAnEnd) {
    for (const Vec3& entry : {Vec3(70, 0, 0), Vec3(-10, 0, 0)}) {
        VesselGraph graph = two_veins();
        lead_trunk_to(entry, graph);
        ASSERT_EQ(graph.links.size(), 2u) << entry.transpose();
        EXPECT_NEAR(total_mm(graph), 130.0, 1e-9) << entry.transpose();
    }
}

TEST(PortalTrunk, StaysAsItIsWhereNothingIsNearOrItIsThereAlready) {
    for (const Vec3& entry : {Vec3(30, 0.4, 0), Vec3(60.3, 0, 0), Vec3(30, -15.5, 0)}) {
        VesselGraph graph = two_veins();
        const std::size_t nodes = graph.nodes.size();
        lead_trunk_to(entry, graph);
        EXPECT_NEAR(total_mm(graph), 120.0, 1e-9) << entry.transpose();
        EXPECT_LE(graph.nodes.size(), nodes + 1);
    }
}

TEST(PortalTrunk, NeverLeavesAHepaticVein) {
    VesselGraph graph = two_veins();
    lead_trunk_to(Vec3(30, 14, 0), graph);  // 4 mm from the hepatic vein, 14 from the portal one
    EXPECT_EQ(graph.links.back().system, portal);
    EXPECT_NEAR(total_mm(graph), 134.0, 1e-9);
}

}  // namespace
}  // namespace hepatica
