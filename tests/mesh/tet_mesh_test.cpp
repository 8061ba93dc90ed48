// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tet_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"

namespace hepatica {
namespace {

using testing::HasSubstr;

// Two tetrahedra on either side of one triangle.
TetMesh two_tetrahedra() {
    TetMesh mesh;
    mesh.vertices_mm = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)};
    mesh.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}};
    return mesh;
}

void expect_refused(const TetMesh& mesh, const std::string& problem, const std::string& place) {
    try {
        validate(mesh);
        ADD_FAILURE() << problem;
    } catch (const InputError& error) {
        EXPECT_THAT(error.problem(), HasSubstr(problem));
        EXPECT_EQ(error.place(), place);
    }
}

TEST(TetMeshIsRefused, WhereATetrahedronIsInvertedOrFlat) {
    EXPECT_NO_THROW(validate(two_tetrahedra()));
    TetMesh mesh = two_tetrahedra();
    std::swap(mesh.tetrahedra[1][0], mesh.tetrahedra[1][1]);
    expect_refused(mesh, "flat or inverted", "tetrahedron 1");
    mesh = two_tetrahedra();
    mesh.vertices_mm[4] = Vec3(0.25, 0.25, 0.0);
    expect_refused(mesh, "flat or inverted", "tetrahedron 1");
}

// A millionth of a millimetre: its volume is a number, too.
TEST(TetMeshIsRefused, WithTheVolumeOfATetrahedronHoweverSmall) {
    TetMesh mesh;
    mesh.vertices_mm = {Vec3::Zero(), 1e-6 * Vec3::UnitX(), 1e-6 * Vec3::UnitY(),
                        1e-6 * Vec3::UnitZ()};
    mesh.tetrahedra = {{0, 2, 1, 3}};
    expect_refused(mesh, "(volume -1.66667e-19 mm3)", "tetrahedron 0");
}

TEST(TetMeshIsRefused, WhereAVertexDoesNotExist) {
    for (const int vertex : {-1, 5, std::numeric_limits<int>::max()}) {
        TetMesh mesh = two_tetrahedra();
        mesh.tetrahedra[0][3] = vertex;
        expect_refused(mesh, "names vertex " + std::to_string(vertex), "tetrahedron 0");
    }
}

TEST(TetMeshIsRefused, WhereAPlaceIsNoNumber) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        TetMesh mesh = two_tetrahedra();
        mesh.vertices_mm[2].y() = bad;
        expect_refused(mesh, "is not finite", "vertex 2");
    }
}

}  // namespace
}  // namespace hepatica
