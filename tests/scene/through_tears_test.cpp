// SPDX-License-Identifier: GPL-3.0-or-later
// Where vessels count as torn through: bodies of cubes, whose cubes are told their vessels.
#include "core/scene/through_tears.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scene/cube_body.h"

namespace hepatica {
namespace {

using test::CubeBody;
using test::tree_of;

constexpr double stretch_mm = 2.0;

// A vessel along x to a fork, and two branches side by side.
CubeBody fork_of_cubes() {
    CubeBody body;
    for (int x = 0; x <= 6; ++x) body.add(x, 0, 0, x + 0.5);
    for (int x = 6; x <= 20; ++x) {
        body.add(x, 1, 1, x - 5.5);
        body.add(x, -1, 2, x - 5.5);
    }
    return body;
}

const VesselTree fork_tree = tree_of({-1, 0, 0});

// The ends of the two branches touch and are one in the mesh.
TEST(ThroughTears, OfABranchThatHangsOnItsNeighbourFartherOn) {
    CubeBody body = fork_of_cubes();
    body.add(20, 0, 1, 15.5);
    Tearing tearing(body.mesh, {}, {});
    body.cut(tearing, 13.0, 1.0);
    ASSERT_EQ(tearing.topology().pieces(tearing.bound_pairs()), 1) << "it leads around the cut";
    const auto torn = through_tears(fork_tree, tearing, body.places, stretch_mm);
    ASSERT_EQ(torn.size(), 1u);
    EXPECT_EQ(torn[0].at.segment, 1);
    EXPECT_NEAR(torn[0].at.arclength_mm, 7.0, stretch_mm);
}

// At the fork, the cut lies between two segments.
TEST(ThroughTears, OfABranchAtItsForkThatHangsOnItsNeighbour) {
    CubeBody body = fork_of_cubes();
    body.add(20, 0, 1, 15.5);
    Tearing tearing(body.mesh, {}, {});
    const std::vector<int> joints =
        tearing.crossing(Vec3(5.5, 1, -1), Vec3(2, 0, 0), Vec3(0, 0, 3), body.mesh.vertices_mm);
    ASSERT_FALSE(joints.empty());
    tearing.cut(joints);
    ASSERT_EQ(tearing.topology().pieces(tearing.bound_pairs()), 1);
    const auto torn = through_tears(fork_tree, tearing, body.places, stretch_mm);
    ASSERT_EQ(torn.size(), 1u);
    EXPECT_EQ(torn[0].at.segment, 1);
    EXPECT_EQ(torn[0].at.arclength_mm, 0.0);
}

// A trunk that both branches of its fork came off together, in one piece, is cut once, at its end.
TEST(ThroughTears, OfATrunkAtItsVeryEndIsOne) {
    CubeBody body;
    for (int x = 0; x <= 6; ++x) body.add(x, 0, 0, x + 0.5);
    for (int x = 7; x <= 20; ++x) {
        body.add(x, 0, 1, x - 6.5);
        body.add(x, 1, 2, x - 6.5);
    }
    VesselTree tree = tree_of({-1, 0, 0});
    tree.segments[0].points_mm.back() = Vec3(7, 0, 0);
    Tearing tearing(body.mesh, {}, {});
    body.cut(tearing, 7.0, 0.0);
    ASSERT_EQ(tearing.topology().pieces(tearing.bound_pairs()), 2);
    const auto torn = through_tears(tree, tearing, body.places, stretch_mm);
    ASSERT_EQ(torn.size(), 1u);
    EXPECT_EQ(torn[0].at.segment, 0);
    EXPECT_EQ(torn[0].at.arclength_mm, 7.0);
}

// Each by itself, they are as many tears.
TEST(ThroughTears, OfAllBranchesOneByOneAreAsMany) {
    CubeBody body = fork_of_cubes();
    Tearing tearing(body.mesh, {}, {});
    for (const double y : {1.0, 0.0}) {
        const std::vector<int> joints =
            tearing.crossing(Vec3(5.5, y, -1), Vec3(2, 0, 0), Vec3(0, 0, 3), body.rest_of(tearing));
        ASSERT_FALSE(joints.empty());
        tearing.cut(joints);
    }
    ASSERT_EQ(tearing.topology().pieces(tearing.bound_pairs()), 3);
    const auto torn = through_tears(fork_tree, tearing, body.places, stretch_mm);
    ASSERT_EQ(torn.size(), 2u);
    for (const ThroughTear& one : torn) {
        EXPECT_NE(one.at.segment, 0);
        EXPECT_EQ(one.at.arclength_mm, 0.0);
    }
}

// Meshes of real vessels have segments of several pieces; only the cut is a tear.
TEST(ThroughTears, AreNotWhereTheBodyWasApartFromTheStart) {
    CubeBody body = fork_of_cubes();
    for (int x = 0; x <= 20; ++x)
        if (x != 8) body.add(x, 10, 3, x + 0.5);
    for (int x = 22; x <= 30; ++x) body.add(x, 10, 4, x - 21.5);
    Tearing tearing(body.mesh, {}, {});
    body.cut(tearing, 13.0, 1.0);
    const VesselTree tree = tree_of({-1, 0, 0, -1, 3});
    const auto torn = through_tears(tree, tearing, body.places, stretch_mm);
    ASSERT_EQ(torn.size(), 1u);
    EXPECT_EQ(torn[0].at.segment, 1);
    body.cut(tearing, 13.0, 10.0);
    EXPECT_EQ(through_tears(tree, tearing, body.places, stretch_mm).size(), 2u);
}

// A cut that leaves a part of the wall opens no lumen.
TEST(ThroughTears, AreNotWhereACrumbCameOff) {
    const CubeBody body = fork_of_cubes();
    Tearing tearing(body.mesh, {}, {});
    std::vector<int> joints;
    const std::span<const Joint> all = tearing.topology().joints();
    for (std::size_t j = 0; j < all.size(); ++j)
        if (std::ranges::find(all[j].tetrahedra, 100) != all[j].tetrahedra.end())
            joints.push_back(static_cast<int>(j));
    ASSERT_FALSE(joints.empty());
    tearing.cut(joints);
    ASSERT_GT(tearing.report().vertices_split, 0);
    EXPECT_TRUE(through_tears(fork_tree, tearing, body.places, stretch_mm).empty());
}

}  // namespace
}  // namespace hepatica
