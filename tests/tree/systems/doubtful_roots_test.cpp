// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/systems/doubtful_roots.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/phantom/phantom.h"
#include "core/tree/editing/tree_edit.h"
#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

TreeEdit root_at(const Vec3& place) {
    TreeEdit edit;
    edit.kind = TreeEditKind::set_root;
    edit.at_mm = place;
    return edit;
}

TEST(DoubtfulRoots, ATaperingTreeHasNone) {
    EXPECT_TRUE(doubtful_roots(test::forked_tree()).empty());
    EXPECT_TRUE(doubtful_roots(VesselTree{}).empty());
}

TEST(DoubtfulRoots, ARootOnATwigIsDoubtedWithTheTrunkThatIsAnOutlet) {
    const Vec3 twig(5, 50, -4), trunk(0, 0, 0);
    const VesselTree turned = edited(test::forked_tree(), root_at(twig));
    const auto doubted = doubtful_roots(turned);
    ASSERT_EQ(doubted.size(), 1u);
    EXPECT_EQ(doubted[0].root.at_mm, twig);
    EXPECT_NEAR(doubted[0].root.radius_mm, 1.65, 0.05) << "the twig runs from 1.9 to 1.6 mm";
    EXPECT_EQ(doubted[0].wider_end.at_mm, trunk);
    EXPECT_NEAR(doubted[0].wider_end.radius_mm, 3.97, 0.05) << "the trunk from 4.0 to 3.7 mm";
    const auto told = sentences(doubted);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_NE(told[0].find("5.0, 50.0, -4.0 mm"), std::string::npos) << told[0];
    EXPECT_NE(told[0].find("0.0, 0.0, 0.0 mm"), std::string::npos) << told[0];
    EXPECT_TRUE(doubtful_roots(edited(turned, root_at(trunk))).empty());
}

// The widths decide, not where the tree begins.
TEST(DoubtfulRoots, EndsThatAreLittleWiderOrNarrowAreNotDoubted) {
    const auto tree_of = [](double root_mm, double end_mm) {
        VesselGraph graph;
        graph.nodes = {{Vec3(0, 0, 0), root_mm}, {Vec3(0, 0, 40), end_mm}};
        graph.links = {test::straight_link(graph, 0, 1, root_mm, end_mm)};
        const RootWish root{0, VascularSystem::unknown};
        return directed(graph, std::span(&root, 1));
    };
    EXPECT_EQ(doubtful_roots(tree_of(2.0, 3.6)).size(), 1u);
    EXPECT_TRUE(doubtful_roots(tree_of(2.0, 2.9)).empty()) << "not 1.5 times as wide";
    EXPECT_TRUE(doubtful_roots(tree_of(0.5, 2.4)).empty()) << "narrower than 2.5 mm";
}

// One ball at the very end, as a skeleton's end in a wide lumen may have it, sways nothing.
TEST(DoubtfulRoots, OneOddSectionSwaysNothing) {
    VesselTree tree = test::forked_tree();
    for (VesselSegment& segment : tree.segments) segment.radii_mm.back() = 20.0;
    EXPECT_TRUE(doubtful_roots(tree).empty());
}

// Where a loop closes, no blood leaves the tree.
TEST(DoubtfulRoots, TheWideMeetingOfALoopIsNoEnd) {
    VesselGraph graph;
    graph.nodes = {
        {Vec3(0, 0, 0), 2.0}, {Vec3(0, 0, 20), 2.0}, {Vec3(20, 0, 40), 2.0}, {Vec3(0, 0, 40), 5.0}};
    graph.links = {
        test::straight_link(graph, 0, 1, 2.0, 2.0), test::straight_link(graph, 1, 2, 2.0, 2.0),
        test::straight_link(graph, 2, 3, 2.0, 5.0), test::straight_link(graph, 1, 3, 2.0, 5.0)};
    const RootWish root{0, VascularSystem::unknown};
    VesselTree tree = directed(graph, std::span(&root, 1));
    ASSERT_TRUE(std::ranges::any_of(tree.segments, &VesselSegment::closes_loop));
    EXPECT_TRUE(doubtful_roots(tree).empty());
}

// Each system of a synthetic patient is filled from its widest end.
TEST(DoubtfulRoots, SyntheticPatientsHaveNone) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        PhantomOptions options;
        options.seed = seed;
        options.systems = 2;
        options.dims = {64, 64, 64};
        options.spacing_mm = Vec3(3, 3, 3);
        Job job;
        EXPECT_TRUE(doubtful_roots(make_phantom(options, job).tree).empty()) << "seed " << seed;
    }
}

}  // namespace
}  // namespace hepatica
