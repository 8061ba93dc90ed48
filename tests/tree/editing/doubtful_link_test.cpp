// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/editing/doubtful_link.h"

#include <gtest/gtest.h>

#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

// Two straight vessels in parallel, whose walls lie this far apart.
VesselTree two_vessels(double gap_mm, double radius_mm, VascularSystem first,
                       VascularSystem second) {
    VesselGraph graph;
    const double apart_mm = gap_mm + 2.0 * radius_mm;
    for (const Vec3& place :
         {Vec3(0, 0, 0), Vec3(0, 40, 0), Vec3(apart_mm, 0, 0), Vec3(apart_mm, 40, 0)})
        graph.nodes.push_back({place, radius_mm});
    graph.links = {test::straight_link(graph, 0, 1, radius_mm, radius_mm, first),
                   test::straight_link(graph, 2, 3, radius_mm, radius_mm, second)};
    return directed(graph);
}

TreeEdit link_across(const VesselTree& tree) {
    TreeEdit edit;
    edit.kind = TreeEditKind::add_link;
    edit.at_mm = tree.segments[0].points_mm[4];
    edit.to_mm = tree.segments[1].points_mm[4];
    return edit;
}

std::vector<std::string> doubts(double gap_mm, double radius_mm,
                                VascularSystem first = VascularSystem::portal,
                                VascularSystem second = VascularSystem::portal) {
    const VesselTree tree = two_vessels(gap_mm, radius_mm, first, second);
    return doubts_of_link(tree, link_across(tree));
}

TEST(DoubtfulLink, JoinsTwoSystems) {
    const auto said = doubts(2.0, 2.0, VascularSystem::portal, VascularSystem::hepatic);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("second end (hepatic veins)"), std::string::npos) << said[0];
    EXPECT_NE(said[0].find("first (portal vein)"), std::string::npos) << said[0];
    EXPECT_TRUE(doubts(2.0, 2.0).empty());
    EXPECT_TRUE(doubts(2.0, 2.0, VascularSystem::unknown, VascularSystem::hepatic).empty())
        << "a piece without a system takes that of what it hangs on";
    EXPECT_TRUE(doubts(2.0, 2.0, VascularSystem::portal, VascularSystem::unknown).empty());
}

// The sentence tells what edited() does.
TEST(DoubtfulLink, GivesTheSecondVesselTheSystemOfTheFirst) {
    const VesselTree tree = two_vessels(2.0, 2.0, VascularSystem::portal, VascularSystem::hepatic);
    const VesselTree joined = edited(tree, link_across(tree));
    for (const VesselSegment& segment : joined.segments)
        EXPECT_EQ(segment.system, VascularSystem::portal);
}

TEST(DoubtfulLink, IsLongerThanFiveDiametersOrTwentyMillimetres) {
    EXPECT_TRUE(doubts(9.9, 1.0).empty());
    ASSERT_EQ(doubts(10.1, 1.0).size(), 1u) << "of vessels 2 mm wide";
    EXPECT_NE(doubts(10.1, 1.0)[0].find("over 10.1 mm from wall to wall"), std::string::npos);
    EXPECT_TRUE(doubts(19.9, 5.0).empty());
    EXPECT_EQ(doubts(20.1, 5.0).size(), 1u);
    EXPECT_EQ(doubts(60.0, 2.0, VascularSystem::hepatic, VascularSystem::portal).size(), 2u);
}

// Of two vessels the wider one counts: a twig may have lost its beginning beside a trunk.
TEST(DoubtfulLink, IsMeasuredByTheWiderVessel) {
    VesselTree tree = two_vessels(10.0, 1.0, VascularSystem::portal, VascularSystem::portal);
    EXPECT_TRUE(doubts_of_link(tree, link_across(tree)).empty());
    for (double& radius_mm : tree.segments[1].radii_mm) radius_mm = 0.5;
    EXPECT_EQ(doubts_of_link(tree, link_across(tree)).size(), 1u) << "10.5 mm, five times 2 mm";
    for (double& radius_mm : tree.segments[0].radii_mm) radius_mm = 1.2;
    EXPECT_TRUE(doubts_of_link(tree, link_across(tree)).empty()) << "10.3 mm, five times 2.4 mm";
}

TEST(DoubtfulLink, IsNoneThatWasOfferedOrIsImpossible) {
    const VesselTree tree = two_vessels(60.0, 2.0, VascularSystem::portal, VascularSystem::hepatic);
    const TreeEdit link = link_across(tree);
    ASSERT_EQ(doubts_of_link(tree, link).size(), 2u);
    TreeEdit offered = link;
    offered.path_mm = {0.5 * (link.at_mm + link.to_mm)};
    EXPECT_TRUE(doubts_of_link(tree, offered).empty());
    TreeEdit other = link;
    other.kind = TreeEditKind::cut_link;
    EXPECT_TRUE(doubts_of_link(tree, other).empty());
    TreeEdit beside = link;
    beside.to_mm += Vec3(0, 0, 10.1);
    EXPECT_TRUE(doubts_of_link(tree, beside).empty());
    EXPECT_TRUE(doubts_of_link({}, link).empty());
}

}  // namespace
}  // namespace hepatica
