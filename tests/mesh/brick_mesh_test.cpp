// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes whose vertices, volumes and bends are known in closed form.
#include "core/mesh/brick_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/mesh/quality.h"
#include "core/mesh/surface.h"
#include "tests/mesh/bend_along_x.h"
#include "tests/support/enclosed_volume.h"

namespace hepatica {
namespace {

const Vec3 size_mm(12.0, 6.0, 2.0);
constexpr Index3 cells{4, 3, 1};

TEST(BrickMesh, NumbersVerticesAlongXThenYThenZ) {
    const HexMesh brick = hexahedral_brick(size_mm, cells);
    ASSERT_EQ(brick.vertices_mm.size(), 5u * 4u * 2u);
    for (int k = 0; k <= 1; ++k)
        for (int j = 0; j <= 3; ++j)
            for (int i = 0; i <= 4; ++i)
                EXPECT_EQ(brick.vertices_mm[i + 5 * (j + 4 * k)], Vec3(3.0 * i, 2.0 * j, 2.0 * k));
    EXPECT_EQ(kuhn_brick(size_mm, cells).vertices_mm, brick.vertices_mm);
}

// Corners in VTK's order: around the bottom, then around the top.
TEST(BrickMesh, NamesTheCornersOfEachCellInOrder) {
    const HexMesh brick = hexahedral_brick(size_mm, cells);
    ASSERT_EQ(brick.hexahedra.size(), 12u);
    const Vec3 steps[8] = {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0},
                           {0, 0, 2}, {3, 0, 2}, {3, 2, 2}, {0, 2, 2}};
    std::size_t cell = 0;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 4; ++i, ++cell)
            for (int c = 0; c < 8; ++c)
                EXPECT_EQ(brick.vertices_mm[brick.hexahedra[cell][c]],
                          Vec3(3.0 * i, 2.0 * j, 0.0) + steps[c])
                    << "cell " << cell << " corner " << c;
}

TEST(BrickMesh, CutsEachCellIntoSixEqualConformingTetrahedra) {
    const TetMesh mesh = kuhn_brick(size_mm, {4, 3, 2});
    EXPECT_EQ(mesh.tetrahedra.size(), 6u * 24u);
    validate(mesh);
    for (const auto& [a, b, c, d] : mesh.tetrahedra)
        EXPECT_NEAR(signed_volume_mm3(mesh.vertices_mm[a], mesh.vertices_mm[b], mesh.vertices_mm[c],
                                      mesh.vertices_mm[d]),
                    144.0 / 24.0 / 6.0, 1e-12);
    // Faces between cells belong to two tetrahedra: two triangles are left on each outer square.
    const TriangleMesh surface = surface_of(mesh).mesh;
    EXPECT_EQ(surface.triangles.size(), 2u * 2u * (4u * 3u + 3u * 2u + 4u * 2u));
    EXPECT_TRUE(is_closed_manifold(surface));
    EXPECT_NEAR(test::enclosed_volume_mm3(surface), 144.0, 1e-10);
}

TEST(BrickMesh, RefusesABoxWithoutVolume) {
    const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        for (const double bad : {0.0, -1.0, nan, infinite}) {
            Vec3 size(1.0, 1.0, 1.0);
            size[axis] = bad;
            EXPECT_THROW(hexahedral_brick(size, {1, 1, 1}), InputError);
        }
        Index3 none{1, 1, 1};
        none[axis] = 0;
        EXPECT_THROW(hexahedral_brick(Vec3(1.0, 1.0, 1.0), none), InputError);
    }
    EXPECT_NO_THROW(hexahedral_brick(Vec3(1.0, 1.0, 1.0), {1, 1, 1}));
}

// A quarter circle: the middle of the box becomes the arc of radius length/angle around an axis
// above it, its length is kept, and cross-sections stay plane, radial and as they were along z.
TEST(BrickMesh, BendsAroundAnAxisBesideTheBox) {
    constexpr double length = 30.0, middle = 1.0, angle = M_PI / 2.0, radius = length / angle;
    std::vector<Vec3> points;
    for (const double x : {0.0, 10.0, 20.0, 30.0})
        for (const double y : {0.0, 1.0, 2.0}) points.emplace_back(x, y, 5.0 * y);
    std::vector<Vec3> bent = points;
    test::bend_along_x(bent, length, middle, angle);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 arm = bent[i] - Vec3(0.0, middle + radius, bent[i].z());
        EXPECT_NEAR(arm.norm(), radius + middle - points[i].y(), 1e-12);
        EXPECT_NEAR(std::atan2(arm.x(), -arm.y()), points[i].x() / radius, 1e-12);
        EXPECT_EQ(bent[i].z(), points[i].z());
    }
    EXPECT_LT((bent[1] - Vec3(0, middle, 5)).norm(), 1e-12);  // the clamped end stays
    TetMesh mesh = kuhn_brick(Vec3(30, 2, 2), {60, 2, 2});
    test::bend_along_x(mesh.vertices_mm, length, middle, angle);
    validate(mesh);
    EXPECT_NEAR(volume_mm3(mesh) / 120.0, 1.0, 1e-3);  // Pappus: the middle's length times the area
}

}  // namespace
}  // namespace hepatica
