// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/mesh/surface.h"

namespace hepatica {
namespace {

TetMesh regular_tetrahedron() {
    return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 2, 1, 3}}};
}

// Six tetrahedra around the diagonal of the unit cube.
TetMesh cube() {
    TetMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.vertices_mm.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
    mesh.tetrahedra = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                       {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    validate(mesh);
    return mesh;
}

TEST(Quality, KnowsTheRegularTetrahedron) {
    const MeshQuality quality = quality_of(regular_tetrahedron());
    const double angle = std::acos(1.0 / 3.0) * 180.0 / M_PI;  // 70.53 degrees
    EXPECT_NEAR(quality.min_dihedral_deg, angle, 1e-10);
    EXPECT_NEAR(quality.max_dihedral_deg, angle, 1e-10);
    EXPECT_TRUE(quality.closed);
    EXPECT_EQ(quality.handles, 0);
}

TEST(Quality, KnowsTheCube) {
    const MeshQuality quality = quality_of(cube());
    EXPECT_NEAR(quality.volume_mm3, 1.0, 1e-14);
    EXPECT_NEAR(quality.min_dihedral_deg, 45.0, 1e-10);
    EXPECT_NEAR(quality.max_dihedral_deg, 90.0, 1e-10);
    EXPECT_EQ(quality.components, 1);
    EXPECT_TRUE(quality.closed);
}

TEST(Quality, SeesBodiesThatTouchInAPointAsNotManifold) {
    TetMesh mesh = regular_tetrahedron();
    for (const Vec3& vertex : {Vec3(3, 1, 1), Vec3(1, 3, 1), Vec3(1, 1, 3)})
        mesh.vertices_mm.push_back(vertex);
    mesh.tetrahedra.push_back({0, 4, 5, 6});
    validate(mesh);
    EXPECT_FALSE(quality_of(mesh).closed);
}

TEST(Quality, CountsBodiesAndCavities) {
    TetMesh two = regular_tetrahedron();
    for (int i = 0; i < 4; ++i) two.vertices_mm.push_back(two.vertices_mm[i] + Vec3(9, 0, 0));
    two.tetrahedra.push_back({4, 6, 5, 7});
    EXPECT_EQ(quality_of(two).components, 2);
    EXPECT_EQ(quality_of(two).boundary_components, 2);
    EXPECT_EQ(quality_of(TetMesh{}).components, 0);
}

TEST(Surface, EnclosesTheVolumeOfItsBody) {
    const BodySurface surface = surface_of(cube());
    EXPECT_EQ(surface.mesh.triangles.size(), 12u);
    EXPECT_NEAR(enclosed_volume_mm3(surface.mesh), 1.0, 1e-14);
    EXPECT_NO_THROW(validate_closed(surface.mesh));
}

TEST(Surface, NamesTheEdgeWhereItIsOpen) {
    TriangleMesh surface = surface_of(cube()).mesh;
    surface.triangles.pop_back();
    EXPECT_THROW(validate_closed(surface), InputError);
}

TEST(Surface, KeepsOnlyVerticesOfTheBoundary) {
    TetMesh mesh = cube();
    mesh.vertices_mm.insert(mesh.vertices_mm.begin(), Vec3(5, 5, 5));  // used by nothing
    for (auto& tetrahedron : mesh.tetrahedra)
        for (int& vertex : tetrahedron) ++vertex;
    const BodySurface surface = surface_of(mesh);
    EXPECT_EQ(surface.mesh.vertices_mm.size(), 8u);
    EXPECT_EQ(surface.body_vertex.front(), 1);
    EXPECT_NEAR(enclosed_volume_mm3(surface.mesh), 1.0, 1e-14);
}

}  // namespace
}  // namespace hepatica
