// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/systems/portal_trunk.h"

#include <gtest/gtest.h>

#include <algorithm>

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
        lead_trunk_to(entry, graph);
        EXPECT_NEAR(total_mm(graph), 120.0, 1e-9) << entry.transpose();
        EXPECT_EQ(graph.nodes.size(), two_veins().nodes.size()) << entry.transpose();
        EXPECT_EQ(graph.links.size(), two_veins().links.size()) << entry.transpose();
    }
}

TEST(PortalTrunk, NeverLeavesAHepaticVein) {
    VesselGraph graph = two_veins();
    lead_trunk_to(Vec3(30, 14, 0), graph);  // 4 mm from the hepatic vein, 14 from the portal one
    EXPECT_EQ(graph.links.back().system, portal);
    EXPECT_NEAR(total_mm(graph), 134.0, 1e-9);
}

// From (0, 0, 0) a trunk of 5 mm radius that divides at (60, 0, 0) into branches of 100 and 80 mm.
// Where `joined` is set a vessel of 20 mm joins it at (30, 0, 0), another at (58, 0, 0).
VesselGraph trunk_that_divides(bool joined) {
    VesselGraph graph;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(30, 0, 0), Vec3(58, 0, 0), Vec3(60, 0, 0),
                          Vec3(160, 0, 0), Vec3(60, 80, 0), Vec3(30, 20, 0), Vec3(58, -20, 0)})
        graph.nodes.push_back({p, 5});
    for (const auto& [from, to] : {std::pair{0, 1}, {1, 2}, {2, 3}})
        graph.links.push_back(straight_link(graph, from, to, 5, 5, portal));
    graph.links.push_back(straight_link(graph, 3, 4, 4, 2, portal));
    graph.links.push_back(straight_link(graph, 3, 5, 3, 2, portal));
    if (joined)
        for (const auto& [from, to] : {std::pair{1, 6}, {2, 7}})
            graph.links.push_back(straight_link(graph, from, to, 2, 2, portal));
    join_passing_nodes(graph);
    return graph;
}

VesselTree begun_at(const VesselGraph& graph, const Vec3& root_mm) {
    for (std::size_t n = 0; n < graph.nodes.size(); ++n)
        if (graph.nodes[n].position_mm == root_mm) {
            const RootWish wish{static_cast<int>(n), portal};
            return directed(graph, {&wish, 1});
        }
    return directed(graph);
}

// What joins the trunk within its last radius stays.
TEST(PortalTrunk, BeginsOneRadiusBeforeItDivides) {
    for (const bool joined : {false, true}) {
        const VesselTree tree = begun_at(trunk_that_divides(joined), Vec3(0, 0, 0));
        const auto made = short_trunk(tree, Vec3(1, 2, 0), {});
        ASSERT_TRUE(made);
        EXPECT_LT((made->begins_mm - Vec3(55, 0, 0)).norm(), 1e-6);
        EXPECT_NEAR(total_mm(made->graph), 5.0 + 180.0 + (joined ? 20.0 : 0.0), 1e-6);
        EXPECT_EQ(made->beside.count, joined ? 1 : 0);
        EXPECT_NEAR(made->beside.length_mm, joined ? 20.0 : 0.0, 1e-6);
        double farthest_mm = 0.0;
        for (const VesselSeed& left_out : made->left_out) {
            EXPECT_EQ(left_out.system, portal);
            EXPECT_LE(left_out.position_mm.x(), 55.0 + 1e-6);
            farthest_mm = std::max(farthest_mm, left_out.position_mm.y());
        }
        EXPECT_NEAR(farthest_mm, joined ? 20.0 : 0.0, 1e-6) << "what hung on the trunk, too";
        const VesselTree shorter = begun_at(made->graph, made->begins_mm);
        EXPECT_EQ(roots(shorter).size(), 1u);
        EXPECT_FALSE(short_trunk(shorter, made->begins_mm, {})) << "it is short already";
    }
}

// The trunk goes on into other organs, and the tree begins at a stub beside it (a real patient).
TEST(PortalTrunk, LosesWhatGoesOnBesideItsRoot) {
    VesselGraph with_stub = trunk_that_divides(true);
    const auto at = std::ranges::find_if(
        with_stub.nodes, [](const VesselNode& n) { return n.position_mm == Vec3(30, 0, 0); });
    const int fork = static_cast<int>(at - with_stub.nodes.begin());
    with_stub.nodes.push_back({Vec3(30, -4, 0), 5});
    with_stub.links.push_back(
        straight_link(with_stub, fork, static_cast<int>(with_stub.nodes.size()) - 1, 5, 5, portal));
    const auto made = short_trunk(begun_at(with_stub, Vec3(30, -4, 0)), Vec3(30, -4, 0), {});
    ASSERT_TRUE(made);
    EXPECT_LT((made->begins_mm - Vec3(55, 0, 0)).norm(), 1e-6);
    EXPECT_EQ(made->beside.count, 2) << "the trunk's own beginning and what joins it there";
    EXPECT_NEAR(made->beside.length_mm, 50.0, 1e-6);
    EXPECT_NEAR(total_mm(made->graph), 205.0, 1e-6);
}

TEST(PortalTrunk, StaysLongWhereItMay) {
    const VesselTree tree = begun_at(trunk_that_divides(true), Vec3(0, 0, 0));
    EXPECT_FALSE(short_trunk(tree, Vec3(0, 16, 0), {})) << "it was seen elsewhere";
    for (const Vec3& seed : {Vec3(20, 1, 0), Vec3(50, -1, 0), Vec3(30, 12, 1)})
        EXPECT_FALSE(short_trunk(tree, Vec3(0, 0, 0), {{seed, portal}})) << seed.transpose();
    EXPECT_TRUE(short_trunk(tree, Vec3(0, 0, 0), {{Vec3(100, 1, 0), portal}}));
    EXPECT_FALSE(short_trunk(directed(two_veins()), Vec3(0, 0, 0), {})) << "it never divides";
    VesselGraph veins = trunk_that_divides(true);
    for (VesselLink& link : veins.links) link.system = hepatic;
    EXPECT_FALSE(short_trunk(directed(veins), Vec3(0, 0, 0), {}));
}

}  // namespace
}  // namespace hepatica
