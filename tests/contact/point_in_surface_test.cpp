// SPDX-License-Identifier: GPL-3.0-or-later
// Points in and beside boxes, of which the closed form knows on which side they are.
#include "core/contact/point_in_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "tests/contact/bodies.h"

namespace hepatica {
namespace {

TEST(PointInSurface, LiesInABoxWhereItsCoordinatesDo) {
    test::Boxes boxes;
    boxes.add(Vec3(0, 0, 0), 0.0);
    const auto features = boxes.features(4);
    const SurfacePatches& surface = features.surface();
    const auto& x = boxes.mesh.vertices_mm;
    const std::vector<Box> around = boxes_of_patches(surface, x);
    std::vector<int> all(surface.size());
    std::iota(all.begin(), all.end(), 0);
    test::RandomFeatures random(3);
    int inside = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3 point = random.point(4.0);
        const bool in = (point.cwiseAbs() - Vec3(3, 1, 1)).maxCoeff() < 0.0;
        EXPECT_EQ(lies_within(point, surface, all, around, x), in) << point.transpose();
        inside += in ? 1 : 0;
    }
    EXPECT_GT(inside, 50);
    // Along the diagonals of its faces and through its corners.
    EXPECT_TRUE(lies_within(Vec3::Zero(), surface, all, around, x));
    EXPECT_FALSE(lies_within(Vec3(0, 0, 3), surface, all, around, x));
}

// A tetrahedron beside the origin, of which a ray from there meets an edge and nothing else: its
// triangles face outward, and those at the edge begin with it. The products that say so are exact.
void add_grazed(const Vec3& ray, std::vector<std::array<int, 3>>& triangles, std::vector<Vec3>& x) {
    const Vec3 along(8, 0, 0), across = along.cross(ray).normalized();
    const int first = static_cast<int>(x.size());
    x.insert(x.end(), {along, 16.0 * ray - along, 8.0 * ray + 3.0 * across + 5.0 * ray,
                       8.0 * ray + 3.0 * across - 5.0 * ray});
    for (std::array<int, 4> corners :
         {std::array{0, 1, 2, 3}, {0, 1, 3, 2}, {2, 3, 0, 1}, {2, 3, 1, 0}}) {
        for (int& corner : corners) corner += first;
        auto& [a, b, c, opposite] = corners;
        if ((x[b] - x[a]).cross(x[c] - x[a]).dot(x[opposite] - x[a]) > 0.0) std::swap(a, b);
        triangles.push_back({a, b, c});
    }
}

// One side of each edge is left there, the other one is entered.
TEST(PointInSurface, AnEdgeThatTwoRaysGrazeIsNotCrossed) {
    std::vector<std::array<int, 3>> triangles;
    std::vector<Vec3> x;
    add_grazed(Vec3(0.5377, 0.8339, 0.1247), triangles, x);
    add_grazed(Vec3(-0.2259, 0.8622, -0.4534), triangles, x);
    for (int turn = 0; turn < 3; ++turn) {
        const SurfacePatches surface(triangles);
        std::vector<int> all(surface.size());
        std::iota(all.begin(), all.end(), 0);
        EXPECT_FALSE(lies_within(Vec3::Zero(), surface, all, boxes_of_patches(surface, x), x))
            << turn;
        const Vec3 middle = (x[0] + x[1] + x[2] + x[3]) / 4.0;
        EXPECT_TRUE(lies_within(middle, surface, all, boxes_of_patches(surface, x), x)) << turn;
        for (std::array<int, 3>& t : triangles) std::ranges::rotate(t, t.begin() + 1);
    }
}

}  // namespace
}  // namespace hepatica
