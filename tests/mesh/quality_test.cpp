// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/quality.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/mesh/hex_mesh.h"
#include "core/mesh/surface.h"
#include "tests/support/enclosed_volume.h"

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

TEST(Quality, CountsATunnelAsAHandleAndACavityAsABoundary) {
    // Eight cubes around a hole that runs through.
    TetMesh ring;
    for (int k = 0; k <= 1; ++k)
        for (int j = 0; j <= 3; ++j)
            for (int i = 0; i <= 3; ++i) ring.vertices_mm.emplace_back(i, j, k);
    std::vector<std::array<int, 8>> cells;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            if (i == 1 && j == 1) continue;
            const int base = i + 4 * j;
            cells.push_back(
                {base, base + 1, base + 5, base + 4, base + 16, base + 17, base + 21, base + 20});
        }
    ring.tetrahedra = cut_into_tetrahedra(cells);
    const MeshQuality torus = quality_of(ring);
    EXPECT_EQ(torus.components, 1);
    EXPECT_EQ(torus.boundary_components, 1);
    EXPECT_EQ(torus.handles, 1);
    EXPECT_TRUE(torus.closed);
    EXPECT_NEAR(torus.volume_mm3, 8.0, 1e-12);
    // Twenty-six cubes around an empty one in the middle.
    TetMesh shell;
    for (int k = 0; k <= 3; ++k)
        for (int j = 0; j <= 3; ++j)
            for (int i = 0; i <= 3; ++i) shell.vertices_mm.emplace_back(i, j, k);
    cells.clear();
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) {
                if (i == 1 && j == 1 && k == 1) continue;
                const int base = i + 4 * j + 16 * k;
                cells.push_back({base, base + 1, base + 5, base + 4, base + 16, base + 17,
                                 base + 21, base + 20});
            }
    shell.tetrahedra = cut_into_tetrahedra(cells);
    const MeshQuality hollow = quality_of(shell);
    EXPECT_EQ(hollow.components, 1);
    EXPECT_EQ(hollow.boundary_components, 2);
    EXPECT_EQ(hollow.handles, 0);
    EXPECT_TRUE(hollow.closed);
    EXPECT_NEAR(hollow.volume_mm3, 26.0, 1e-12);
}

// Pairs of faces of the corner tetrahedron: three right angles, three of acos(1/sqrt 3).
TEST(Quality, MeasuresTheDihedralAnglesOfACorner) {
    const DihedralRange range = dihedral_angles({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    EXPECT_NEAR(range.max_deg, 90.0, 1e-10);
    EXPECT_NEAR(range.min_deg, std::acos(1.0 / std::sqrt(3.0)) * 180.0 / M_PI, 1e-10);
    // The flat one: angles of 0 and 180 degrees.
    const DihedralRange flat = dihedral_angles({0, 0, 0}, {1, 0, 0}, {1, 1, 1e-9}, {0, 1, 0});
    EXPECT_NEAR(flat.min_deg, 0.0, 1e-5);
    EXPECT_NEAR(flat.max_deg, 180.0, 1e-5);
}

TEST(TetMesh, RefusesWhatIsNoBody) {
    const auto refused = [](TetMesh mesh, const std::string& place) {
        try {
            validate(mesh);
        } catch (const InputError& error) {
            return std::string(error.what()).find(place) != std::string::npos;
        }
        return false;
    };
    TetMesh mesh = cube();
    mesh.vertices_mm[5].y() = std::nan("");
    EXPECT_TRUE(refused(mesh, "vertex 5"));
    for (const int wrong : {-1, 8}) {
        mesh = cube();
        mesh.tetrahedra[4][2] = wrong;
        EXPECT_TRUE(refused(mesh, "tetrahedron 4"));
    }
    mesh = cube();
    std::swap(mesh.tetrahedra[2][0], mesh.tetrahedra[2][1]);
    EXPECT_TRUE(refused(mesh, "tetrahedron 2"));
    mesh = cube();
    mesh.vertices_mm[7] = mesh.vertices_mm[0];
    EXPECT_TRUE(refused(mesh, "tetrahedron 0"));
}

TEST(TetMesh, HasItsOuterFacesInTheOrderOfTheTetrahedraTurnedOutwards) {
    TetMesh pair = regular_tetrahedron();  // 0 2 1 3
    pair.vertices_mm.emplace_back(-3, -3, -3);
    pair.tetrahedra.push_back({2, 1, 3, 4});
    validate(pair);
    const std::vector<std::array<int, 3>> faces = boundary_triangles(pair);
    ASSERT_EQ(faces.size(), 6u);
    const Vec3 middle = (pair.vertices_mm[1] + pair.vertices_mm[2] + pair.vertices_mm[3]) / 3.0;
    for (std::size_t f = 0; f < 6; ++f) {
        const auto [a, b, c] = faces[f];
        const Vec3 &p = pair.vertices_mm[a], &q = pair.vertices_mm[b], &r = pair.vertices_mm[c];
        EXPECT_GT((q - p).cross(r - p).dot((p + q + r) / 3.0 - middle), 0.0);
        const bool of_the_first = a == 0 || b == 0 || c == 0;
        EXPECT_EQ(of_the_first, f < 3);
    }
}

TEST(Surface, EnclosesTheVolumeOfItsBody) {
    const BodySurface surface = surface_of(cube());
    EXPECT_EQ(surface.mesh.triangles.size(), 12u);
    EXPECT_NEAR(test::enclosed_volume_mm3(surface.mesh), 1.0, 1e-14);
    EXPECT_NO_THROW(validate_closed(surface.mesh));
}

// Whichever triangle is missing, the edge named is one of its three.
TEST(Surface, NamesTheEdgeWhereItIsOpen) {
    const TriangleMesh whole = surface_of(cube()).mesh;
    for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
        TriangleMesh surface = whole;
        const auto [a, b, c] = surface.triangles[t];
        surface.triangles.erase(surface.triangles.begin() + static_cast<std::ptrdiff_t>(t));
        try {
            validate_closed(surface);
            ADD_FAILURE() << "triangle " << t << " is not missed";
        } catch (const InputError& error) {
            const std::string words = error.what();
            bool named = false;
            for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}, {b, a}, {c, b}, {a, c}})
                named = named || words.find("between vertices " + std::to_string(from) + " and " +
                                            std::to_string(to)) != std::string::npos;
            EXPECT_TRUE(named) << words << " without " << a << " " << b << " " << c;
        }
        EXPECT_FALSE(is_closed_manifold(surface));
    }
}

TEST(Surface, RefusesTrianglesThatNameNoVertexOrTurnTheOtherWay) {
    TriangleMesh surface = surface_of(cube()).mesh;
    for (const int wrong : {-1, 8}) {
        TriangleMesh damaged = surface;
        damaged.triangles[3][1] = wrong;
        EXPECT_THROW(validate_closed(damaged), InputError);
    }
    std::swap(surface.triangles[5][0], surface.triangles[5][1]);
    EXPECT_THROW(validate_closed(surface), InputError);
    EXPECT_FALSE(is_closed_manifold(surface));
}

// Its edges cancel out: from a to a, and there and back between a and b.
TEST(Surface, RefusesATriangleThatNamesAVertexTwice) {
    for (const std::array<int, 3>& flat :
         {std::array{2, 2, 5}, std::array{5, 2, 2}, std::array{2, 5, 2}, std::array{2, 2, 2}}) {
        TriangleMesh surface = surface_of(cube()).mesh;
        surface.triangles.push_back(flat);
        try {
            validate_closed(surface);
            ADD_FAILURE() << flat[0] << " " << flat[1] << " " << flat[2] << " is taken";
        } catch (const InputError& error) {
            EXPECT_EQ(error.problem(), "has a triangle with vertex 2 twice");
        }
    }
}

TEST(Surface, KeepsOnlyVerticesOfTheBoundary) {
    TetMesh mesh = cube();
    mesh.vertices_mm.insert(mesh.vertices_mm.begin(), Vec3(5, 5, 5));  // used by nothing
    for (auto& tetrahedron : mesh.tetrahedra)
        for (int& vertex : tetrahedron) ++vertex;
    const BodySurface surface = surface_of(mesh);
    EXPECT_EQ(surface.mesh.vertices_mm.size(), 8u);
    EXPECT_EQ(surface.body_vertex.front(), 1);
    EXPECT_NEAR(test::enclosed_volume_mm3(surface.mesh), 1.0, 1e-14);
}

}  // namespace
}  // namespace hepatica
