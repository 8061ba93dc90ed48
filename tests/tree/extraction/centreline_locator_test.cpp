// SPDX-License-Identifier: GPL-3.0-or-later
// Many queries against the simple search of vessel_tree.h, which is tried against closed forms
// first.
#include "core/tree/extraction/centreline_locator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "core/base/error.h"
#include "core/tree/extraction/bridged_points.h"
#include "tests/mesh/random_tree.h"
#include "tests/support/test_trees.h"

namespace hepatica {
namespace {

TEST(NearestPoint, IsOnTheSegmentAndAtTheArclengthThatItSays) {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, 0), 1.0}, {Vec3(10, 0, 0), 1.0}, {Vec3(10, 20, 0), 1.0}};
    VesselSegment bent;
    bent.proximal_node = 0;
    bent.distal_node = 2;
    bent.points_mm = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 20, 0)};
    bent.radii_mm = {1.0, 1.0, 1.0};
    tree.segments = {bent};
    for (const auto& [query, along, away] : {std::tuple{Vec3(4, -3, 0), 4.0, 3.0},
                                             {Vec3(12, 6, 0), 16.0, 2.0},
                                             {Vec3(-3, 0, 4), 0.0, 5.0},
                                             {Vec3(10, 25, 0), 30.0, 5.0}}) {
        const TreePoint found = nearest_point(tree, query);
        EXPECT_EQ(found.segment, 0);
        EXPECT_NEAR(found.arclength_mm, along, 1e-12);
        EXPECT_NEAR(found.distance_mm, away, 1e-12);
    }
    EXPECT_THROW(nearest_point(VesselTree{}, Vec3::Zero()), InputError);
}

TEST(CentrelineLocator, FindsWhatTheSimpleSearchFinds) {
    const VesselTree tree = test::random_tree(11, 5);
    const CentrelineLocator locator(tree);
    std::mt19937_64 random(12);
    int beyond = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 query(test::uniform(random, -90, 90), test::uniform(random, -90, 90),
                         test::uniform(random, -30, 220));
        const double reach = i % 3 == 0 ? 1e9 : test::uniform(random, 1.0, 40.0);
        const TreePoint exact = nearest_point(tree, query);
        const auto found = locator.nearest(query, reach);
        ASSERT_EQ(found.has_value(), exact.distance_mm <= reach) << i;
        if (!found) {
            ++beyond;
            continue;
        }
        ASSERT_NEAR(found->distance_mm, exact.distance_mm, 1e-9);
        ASSERT_NEAR((found->position_mm - query).norm(), exact.distance_mm, 1e-9);
        const VesselSegment& segment = tree.segments[found->segment];
        const TreePoint on = nearest_point({tree.nodes, {segment}}, query);
        ASSERT_NEAR(on.distance_mm, exact.distance_mm, 1e-9);  // that segment is as near
        // The radius there, by the arclength: these vessels taper evenly from point to point.
        const std::size_t last = segment.points_mm.size() - 1;
        double along = on.arclength_mm, radius = segment.radii_mm[last];
        for (std::size_t p = 1; p <= last; ++p) {
            const double edge = (segment.points_mm[p] - segment.points_mm[p - 1]).norm();
            if (along <= edge) {
                radius = segment.radii_mm[p - 1] +
                         along / edge * (segment.radii_mm[p] - segment.radii_mm[p - 1]);
                break;
            }
            along -= edge;
        }
        ASSERT_NEAR(found->radius_mm, radius, 1e-6);
    }
    EXPECT_GT(beyond, 50);
}

// A tree without extent in two directions, and none at all.
TEST(CentrelineLocator, KnowsStraightVesselsAndEmptyTrees) {
    VesselTree tree;
    tree.nodes = {{Vec3(0, 0, 0), 2.0}, {Vec3(100, 0, 0), 1.0}};
    VesselSegment straight;
    straight.proximal_node = 0;
    straight.distal_node = 1;
    straight.points_mm = {Vec3(0, 0, 0), Vec3(100, 0, 0)};
    straight.radii_mm = {2.0, 1.0};
    tree.segments = {straight};
    const CentrelineLocator locator(tree);
    const auto found = locator.nearest(Vec3(25, 3, 4), 5.0);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->distance_mm, 5.0, 1e-12);
    EXPECT_NEAR(found->radius_mm, 1.75, 1e-12);
    EXPECT_EQ(found->segment, 0);
    EXPECT_FALSE(locator.nearest(Vec3(25, 3, 4), 4.99).has_value());
    EXPECT_FALSE(CentrelineLocator(VesselTree{}).nearest(Vec3::Zero(), 1e9).has_value());
}

TEST(BridgedPoints, AreKnownByTheirPlaceBetweenTheEndsOfABridge) {
    VesselTree tree = test::random_tree(1, 2);
    const std::vector<Vec3>& points = tree.segments[0].points_mm;
    BridgedPoints bridged;
    bridged.mark(tree);
    for (const VesselSegment& segment : tree.segments) EXPECT_TRUE(segment.bridged.empty());
    bridged.add({points[3], points[4], points[5], points[6]});  // the ends lie on vessels
    bridged.mark(tree);
    ASSERT_EQ(tree.segments[0].bridged.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_EQ(tree.segments[0].bridged[i], i == 4 || i == 5) << i;
    EXPECT_TRUE(tree.segments[1].bridged.empty());
    EXPECT_NEAR(bridged_length_mm(tree),
                (points[4] - points[3]).norm() + (points[5] - points[4]).norm() +
                    (points[6] - points[5]).norm(),
                1e-12);
    VesselTree again = test::random_tree(1, 2);
    BridgedPoints from_tree;
    from_tree.add(tree);
    from_tree.mark(again);
    EXPECT_EQ(again.segments[0].bridged, tree.segments[0].bridged);
}

TEST(VesselTree, ValidateNamesTheSegmentThatIsWrong) {
    const auto refused = [](const auto& spoil) {
        VesselTree tree = test::random_tree(2, 3);
        validate(tree);
        spoil(tree);
        try {
            validate(tree);
        } catch (const InputError& error) {
            return std::string(error.what()).find("segment 3") != std::string::npos;
        }
        return false;
    };
    using Tree = VesselTree&;
    const int nodes = static_cast<int>(test::random_tree(2, 3).nodes.size());
    for (const int wrong : {-1, nodes}) {
        EXPECT_TRUE(refused([&](Tree t) { t.segments[3].proximal_node = wrong; })) << wrong;
        EXPECT_TRUE(refused([&](Tree t) { t.segments[3].distal_node = wrong; })) << wrong;
    }
    EXPECT_TRUE(refused([](Tree t) { t.segments[3].parent = 3; }));
    EXPECT_TRUE(refused([](Tree t) { t.segments[3].parent = 0; }));  // ends elsewhere
    EXPECT_TRUE(refused([](Tree t) {
        t.segments[3].points_mm.resize(1);
        t.segments[3].radii_mm.resize(1);
    }));
    EXPECT_TRUE(refused([](Tree t) { t.segments[3].radii_mm.pop_back(); }));
    EXPECT_TRUE(refused([](Tree t) { t.segments[3].bridged = {1}; }));
    EXPECT_TRUE(refused([](Tree t) { t.segments[3].points_mm[2].z() = std::nan(""); }));
    for (const double wrong : {0.0, -1.0, std::nan(""), HUGE_VAL})
        EXPECT_TRUE(refused([&](Tree t) { t.segments[3].radii_mm[1] = wrong; })) << wrong;
    EXPECT_TRUE(refused([](Tree t) { t.segments[3].points_mm[2] = t.segments[3].points_mm[1]; }));
}

TEST(VesselTree, CountsItsEndsForksAndRoots) {
    VesselTree tree = test::random_tree(2, 4);
    EXPECT_EQ(end_count(tree), 9);
    EXPECT_EQ(bifurcation_count(tree), 7);
    EXPECT_EQ(roots(tree), std::vector<int>{0});
    EXPECT_EQ(children(tree)[0].size(), 2u);
    EXPECT_TRUE(children(tree)[14].empty());
    double length = 0.0;
    for (const VesselSegment& s : tree.segments) length += length_mm(s);
    EXPECT_NEAR(length_mm(tree), length, 1e-12);
    tree.segments[4].parent = -1;  // a link of a loop is no root
    tree.segments[4].closes_loop = true;
    EXPECT_EQ(roots(tree), std::vector<int>{0});
    tree.segments[4].closes_loop = false;
    EXPECT_EQ(roots(tree), (std::vector<int>{0, 4}));
}

}  // namespace
}  // namespace hepatica
