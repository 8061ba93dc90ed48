// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/flow_shares.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hepatica {
namespace {

using testing::HasSubstr;

// A trunk of 20 mm that parts into straight branches of these lengths and radii.
VesselTree broom(const std::vector<std::array<double, 2>>& branches) {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, -20), 4.0}, {Vec3::Zero(), 4.0}};
    VesselSegment trunk;
    trunk.proximal_node = 0;
    trunk.distal_node = 1;
    trunk.system = VascularSystem::portal;
    trunk.points_mm = {Vec3(0, 0, -20), Vec3::Zero()};
    trunk.radii_mm = {4.0, 4.0};
    tree.segments.push_back(trunk);
    for (const auto& [length, radius] : branches) {
        const double angle = static_cast<double>(tree.nodes.size());
        const Vec3 end = length * Vec3(std::cos(angle), std::sin(angle), 0.0);
        VesselSegment branch = trunk;
        branch.proximal_node = 1;
        branch.distal_node = static_cast<int>(tree.nodes.size());
        branch.parent = 0;
        branch.points_mm = {Vec3::Zero(), end};
        branch.radii_mm = {radius, radius};
        tree.nodes.push_back({end, radius});
        tree.segments.push_back(branch);
    }
    validate(tree);
    return tree;
}

TEST(FlowShares, OfBranchesAddUpToThatOfTheTrunkAndGrowWithTheRadius) {
    const auto shares = flow_shares(broom({{400, 0.5}, {800, 0.5}, {400, 0.25}}));
    ASSERT_EQ(shares.size(), 4U);
    EXPECT_NEAR(shares[0], 1.0, 1e-9);
    EXPECT_NEAR(shares[1] + shares[2] + shares[3], 1.0, 1e-6);
    EXPECT_GT(shares[1], shares[2]);
    EXPECT_GT(shares[2], shares[3]);
}

TEST(FlowShares, AWideEndThatTakesMostOfTheFlowIsNamed) {
    const VesselTree tree = broom({{60, 1.0}, {6, 3.8}, {60, 1.0}, {70, 1.2}});
    const auto warnings = warnings_of_ends(tree, flow_shares(tree));
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0], HasSubstr("Branch 3 is an end and takes "));
    EXPECT_THAT(warnings[0], HasSubstr(" % of the flow of its tree (portal vein, root: branch 1)"));
    EXPECT_THAT(warnings[0], HasSubstr("Delete it, or set the root there"));
}

// Shares of two trees cannot be compared: each warning says of which it is.
TEST(FlowShares, WarningsNameTheTreeThatTheirShareIsOf) {
    const VesselTree one = broom({{60, 1.0}, {6, 3.8}, {60, 1.0}, {70, 1.2}});
    VesselTree both = one;
    const auto first = static_cast<int>(one.segments.size());
    const auto first_node = static_cast<int>(one.nodes.size());
    both.nodes.insert(both.nodes.end(), one.nodes.begin(), one.nodes.end());
    for (VesselSegment segment : one.segments) {
        if (segment.parent >= 0) segment.parent += first;
        segment.proximal_node += first_node;
        segment.distal_node += first_node;
        segment.system = VascularSystem::hepatic;
        both.segments.push_back(std::move(segment));
    }
    std::vector<double> shares = flow_shares(one);
    shares.insert(shares.end(), shares.begin(), shares.end());
    const auto warnings = warnings_of_ends(both, shares);
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_THAT(warnings[0], HasSubstr("(portal vein, root: branch 1)"));
    EXPECT_THAT(warnings[1], HasSubstr("root: branch " + std::to_string(first + 1) + ")"));
}

TEST(FlowShares, WhereNoEndTakesMoreThanHalfNothingIsSaid) {
    const VesselTree even = broom({{60, 1.0}, {60, 1.0}, {60, 1.0}, {60, 1.0}});
    EXPECT_TRUE(warnings_of_ends(even, flow_shares(even)).empty());
    EXPECT_TRUE(warnings_of_ends(even, {}).empty());  // no flow could be solved
    EXPECT_TRUE(warnings_of_ends(even, {1.0, 0.5, 0.2, 0.2, 0.1}).empty());
    EXPECT_EQ(warnings_of_ends(even, {1.0, 0.51, 0.2, 0.2, 0.09}).size(), 1U);
}

// Beside the thin branch that feeds three or four ends, a wide vessel runs to the same fork.
TEST(FlowShares, AVesselThatClosesALoopIsNoEnd) {
    for (const int ends : {3, 4}) {
        VesselTree tree = broom({{20, 1.0}});
        const Vec3 fork = tree.nodes[2].position_mm;
        for (int i = 0; i < ends; ++i) {
            VesselSegment end = tree.segments[1];
            end.proximal_node = 2;
            end.distal_node = static_cast<int>(tree.nodes.size());
            end.parent = 1;
            end.points_mm = {fork, fork + Vec3(0, 10.0 * i, 60.0)};
            end.radii_mm = {1.5, 1.5};
            tree.nodes.push_back({end.points_mm[1], 1.5});
            tree.segments.push_back(end);
        }
        VesselSegment beside = tree.segments[1];
        beside.closes_loop = true;
        beside.points_mm = {Vec3::Zero(), 0.5 * fork + Vec3(0, 0, 5), fork};
        beside.radii_mm = {3.5, 3.5, 3.5};
        tree.segments.push_back(beside);
        validate(tree);
        const std::vector<double> shares = flow_shares(tree);
        ASSERT_EQ(shares.size(), tree.segments.size());
        EXPECT_GT(shares.back(), 0.9);
        EXPECT_TRUE(warnings_of_ends(tree, shares).empty()) << ends << " ends";
    }
}

TEST(FlowShares, ATreeOfFewEndsMayWellHaveAWideOne) {
    const VesselTree tree = broom({{60, 1.0}, {6, 3.8}, {60, 1.0}});
    EXPECT_TRUE(warnings_of_ends(tree, flow_shares(tree)).empty());
}

}  // namespace
}  // namespace hepatica
