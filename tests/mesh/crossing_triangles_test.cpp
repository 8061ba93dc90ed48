// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles that cross: by construction, to the last digit, and none in a body at rest.
#include "core/mesh/crossing_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

using Pairs = std::vector<std::array<int, 2>>;

TEST(CrossingTriangles, OfTwoThatPierceEachOther) {
    const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {3, 4, 5}};
    std::vector<Vec3> x{Vec3(-1, -1, 0), Vec3(3, -1, 0),   Vec3(-1, 3, 0),
                        Vec3(0, 0, -1),  Vec3(0.1, 0, -1), Vec3(0, 0, 1e-300)};
    EXPECT_EQ(crossing_triangles(triangles, x), (Pairs{{0, 1}}));
    x[5].z() = 0.0;  // it touches
    EXPECT_EQ(crossing_triangles(triangles, x), (Pairs{{0, 1}}));
    x[5].z() = -1e-300;  // and just does not
    EXPECT_TRUE(crossing_triangles(triangles, x).empty());
}

// In plain doubles the sign of x + y - 1 is lost in rounding here.
TEST(CrossingTriangles, IsExactWhereRoundingErrorsDecide) {
    const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {3, 4, 5}};
    const double third = 1.0 - 2.0 / 3.0;  // without rounding
    for (int k = -3; k <= 3; ++k) {
        double y = 2.0 / 3.0;
        for (int i = 0; i < std::abs(k); ++i) y = std::nextafter(y, k > 0 ? 2.0 : 0.0);
        const std::vector<Vec3> x{Vec3(0, 0, 0),      Vec3(1, 0, 0), Vec3(0, 1, 0),
                                  Vec3(third, y, -1), Vec3(9, 9, 0), Vec3(third, y, 1)};
        EXPECT_EQ(crossing_triangles(triangles, x).size(), k <= 0 ? 1u : 0u) << k;
    }
}

TEST(CrossingTriangles, CommonCornersAndEdgesDoNotCountByThemselves) {
    std::vector<Vec3> x{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 2), Vec3(-2, 0, 0)};
    EXPECT_TRUE(
        crossing_triangles(std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 1, 3}}, x).empty());
    const std::vector<std::array<int, 3>> fan{{0, 1, 2}, {0, 3, 4}};
    EXPECT_TRUE(crossing_triangles(fan, x).empty());
    x[3] = Vec3(1, 1, 1);
    x[4] = Vec3(0.2, 0.2, -1);  // the edge from 3 to 4 goes through the first
    EXPECT_EQ(crossing_triangles(fan, x), (Pairs{{0, 1}}));
    const std::vector<std::array<int, 3>> flat{{0, 1, 2}, {3, 4, 4}};
    EXPECT_TRUE(crossing_triangles(flat, x).empty());
}

TEST(CrossingTriangles, NoneInABodyAndSomeWhereItIsPushedIntoItself) {
    TetMesh mesh = kuhn_brick(Vec3(12, 4, 4), {6, 2, 2});
    const auto surface = boundary_triangles(mesh);
    EXPECT_TRUE(crossing_triangles(surface, mesh.vertices_mm).empty());
    for (Vec3& x : mesh.vertices_mm)
        if (x.x() == 12.0) x.x() = 5.0;
    const Pairs crossing = crossing_triangles(surface, mesh.vertices_mm);
    EXPECT_FALSE(crossing.empty());
    EXPECT_TRUE(std::ranges::is_sorted(crossing));
}

}  // namespace
}  // namespace hepatica
