// SPDX-License-Identifier: GPL-3.0-or-later
// A surface beside obstacles: what can meet, what overlaps at rest and for how long, and what of an
// obstacle sticks out.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "core/contact/overlaps.h"
#include "core/contact/pair_cover.h"
#include "tests/contact/bodies.h"

namespace hepatica {
namespace {

// A small box that moves, and around or beside it a larger one that stands still.
struct BoxesBeside {
    test::Boxes boxes;
    std::vector<SurfaceKind> kinds;

    BoxesBeside(SurfaceKind kind, double size, const Vec3& at_mm) {
        boxes.add(Vec3::Zero(), 0.0);
        kinds.assign(boxes.mesh.vertices_mm.size(), SurfaceKind::moving);
        boxes.add(at_mm, 0.3, size);
        kinds.resize(boxes.mesh.vertices_mm.size(), kind);
    }
    SurfaceFeatures features() const {
        return {SurfacePatches(boundary_triangles(boxes.mesh), 4), boxes.mesh.vertices_mm, kinds};
    }
    // The small box moved.
    std::vector<Vec3> moved(const Vec3& by_mm) const {
        std::vector<Vec3> x = boxes.mesh.vertices_mm;
        for (std::size_t v = 0; v < x.size(); ++v)
            if (kinds[v] == SurfaceKind::moving) x[v] += by_mm;
        return x;
    }
};

int counting_pairs(const SurfaceFeatures& features, const Overlaps& overlaps) {
    int count = 0;
    const auto patches = static_cast<int>(features.surface().size());
    for (int p = 0; p < patches; ++p)
        for (int q = p + 1; q < patches; ++q)
            count += features.may_meet(p, q) && !overlaps.left_out(p, q) ? 1 : 0;
    return count;
}

int pairs_that_may_meet(const SurfaceFeatures& features) {
    return counting_pairs(features, Overlaps(features));
}

TEST(BesideObstacles, OnlyWhatMovesAndWhatStandsStillMeet) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> in(-3.0, 3.0);
    const BoxesBeside beside(SurfaceKind::solid, 1.0, Vec3(1.0, 0.5, 2.2));
    const SurfaceFeatures features = beside.features();
    ASSERT_TRUE(features.beside_obstacles());
    const auto first_fixed =
        static_cast<int>(std::ranges::count(beside.kinds, SurfaceKind::moving));
    constexpr double reach = 0.5;
    PairCover cover(features, reach, 0.1);
    const auto all_count = [](int, int) { return false; };
    std::size_t found_any = 0;
    for (int k = 0; k < 30; ++k) {
        const auto from = beside.moved(Vec3(in(random), in(random), 0.3 * in(random)));
        const auto to = beside.moved(Vec3(in(random), in(random), 0.3 * in(random)));
        std::set<std::tuple<bool, int, int>> found;
        for (const FeaturePair& pair : cover.along(from, to, all_count)) {
            const int in_first = pair.of_edges ? 2 : 1;
            EXPECT_NE(pair.nodes[0] < first_fixed, pair.nodes[in_first] < first_fixed);
            found.insert({pair.of_edges, pair.first, pair.second});
        }
        found_any += found.size();
        // Every vertex and triangle of the two that come near at some moment.
        const auto& triangles = features.surface().triangles();
        for (const double time : {0.0, 0.25, 0.5, 0.75, 1.0})
            for (const int v : features.nodes())
                for (std::size_t t = 0; t < triangles.size(); ++t) {
                    if ((v < first_fixed) == (triangles[t][0] < first_fixed)) continue;
                    const auto at = [&](int n) -> Vec3 {
                        return from[n] + time * (to[n] - from[n]);
                    };
                    const Triangle corners{at(triangles[t][0]), at(triangles[t][1]),
                                           at(triangles[t][2])};
                    if (closest(at(v), corners).squared_mm2 < reach * reach) {
                        EXPECT_TRUE(found.contains({false, v, static_cast<int>(t)}));
                    }
                }
    }
    EXPECT_GT(found_any, 100u);
}

TEST(BesideObstacles, WhatLiesInASolidIsLeftOutUntilItIsOut) {
    const BoxesBeside beside(SurfaceKind::solid, 3.0, Vec3(0.1, 0.2, 0.1));
    const SurfaceFeatures features = beside.features();
    Overlaps overlaps(features);
    overlaps.find(beside.boxes.mesh.vertices_mm, 0.01);
    EXPECT_TRUE(overlaps.touching().empty());
    EXPECT_EQ(counting_pairs(features, overlaps), 0);
    EXPECT_FALSE(overlaps.let_go(beside.moved(Vec3(0.3, 0, 0)), 0.1));
    EXPECT_TRUE(overlaps.let_go(beside.moved(Vec3(0, 0, 9)), 0.1));
    EXPECT_EQ(counting_pairs(features, overlaps), pairs_that_may_meet(features));
    // It may not begin to overlap again.
    EXPECT_FALSE(overlaps.let_go(beside.boxes.mesh.vertices_mm, 0.1));
    EXPECT_FALSE(overlaps.any());
}

TEST(BesideObstacles, WhatIsOutsideOfAShellIsLeftOutForGood) {
    const BoxesBeside inside(SurfaceKind::shell, 3.0, Vec3(0.1, 0.2, 0.1));
    const SurfaceFeatures held = inside.features();
    Overlaps overlaps(held);
    overlaps.find(inside.boxes.mesh.vertices_mm, 0.01);
    EXPECT_FALSE(overlaps.any());
    const BoxesBeside outside(SurfaceKind::shell, 3.0, Vec3(0, 0, 9));
    const SurfaceFeatures features = outside.features();
    Overlaps at_rest(features);
    at_rest.find(outside.boxes.mesh.vertices_mm, 0.01);
    EXPECT_EQ(counting_pairs(features, at_rest), 0);
    EXPECT_FALSE(at_rest.let_go(outside.moved(Vec3(0, 0, 9)), 0.1));
    EXPECT_EQ(counting_pairs(features, at_rest), 0);
    // Also while something else is looked at that touches.
    const auto last = static_cast<int>(features.surface().size()) - 1;
    Overlaps both(features);
    ASSERT_TRUE(both.set({{0, last}}, at_rest.buried()));
    EXPECT_TRUE(both.let_go(outside.moved(Vec3(0, 0, 9)), 0.1));
    EXPECT_TRUE(both.touching().empty());
    EXPECT_EQ(both.buried(), at_rest.buried());
    // Also where it is looked for while it happens to be inside.
    Overlaps later(features);
    later.find(outside.moved(Vec3(0, 0, 9)), 0.01, &at_rest);
    EXPECT_EQ(later.buried(), at_rest.buried());
}

// A box that touches at rest, and is then inside: left out with all of the obstacle.
TEST(BesideObstacles, WhatSlipsInIsLeftOutUntilItIsOut) {
    const BoxesBeside beside(SurfaceKind::solid, 3.0, Vec3(0, 0, 4.005));
    const SurfaceFeatures features = beside.features();
    Overlaps overlaps(features);
    overlaps.find(beside.boxes.mesh.vertices_mm, 0.01);
    ASSERT_FALSE(overlaps.touching().empty());
    ASSERT_TRUE(overlaps.buried().empty());
    EXPECT_TRUE(overlaps.let_go(beside.moved(Vec3(0, 0, 4)), 0.1));
    EXPECT_TRUE(overlaps.touching().empty());
    EXPECT_FALSE(overlaps.buried().empty());
    EXPECT_TRUE(overlaps.let_go(beside.moved(Vec3(0, 0, -4)), 0.1));
    EXPECT_FALSE(overlaps.any());
}

// The edges of a box are sharp and the diagonals of its faces are not; seen from inside none is.
TEST(BesideObstacles, WhatSticksOutIsSharp) {
    for (const SurfaceKind kind : {SurfaceKind::solid, SurfaceKind::shell}) {
        const BoxesBeside beside(kind, 2.0, Vec3(9, 0, 0));
        const SurfaceFeatures features = beside.features();
        int sharp = 0, flat = 0;
        for (std::size_t e = 0; e < features.edges().size(); ++e) {
            const auto [a, b] = features.edges()[e];
            const double sharpness = features.sharpness_of_edge(static_cast<int>(e));
            if (beside.kinds[a] == SurfaceKind::moving) {
                EXPECT_EQ(sharpness, 0.0);
            } else {
                (sharpness == 1.0 ? sharp : flat) += 1;
                EXPECT_TRUE(sharpness == 0.0 || sharpness == 1.0) << sharpness;
                EXPECT_EQ(features.sharpness_of_node(a) == 1.0, kind == SurfaceKind::solid) << b;
            }
        }
        // Of 3 x 1 x 1 cells: four times three, and eight across; each of 14 faces has a diagonal.
        EXPECT_EQ(sharp, kind == SurfaceKind::solid ? 20 : 0);
        EXPECT_EQ(flat, 14 + 8 + (kind == SurfaceKind::solid ? 0 : 20));
    }
}

}  // namespace
}  // namespace hepatica
