// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tear/joint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/small_matrix_eigen.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

// Each face is of one or of two tetrahedra: 4 T = 2 J + B.
TEST(Joints, AreTheFacesThatAreNotOnTheSurface) {
    const TetMesh mesh = kuhn_brick(Vec3(4.0, 3.0, 2.0), {4, 3, 2});
    const auto joints = joints_of(mesh);
    EXPECT_EQ(4 * mesh.tetrahedra.size(), 2 * joints.size() + boundary_triangles(mesh).size());
}

TEST(Joints, NameTheSameVerticesOnBothSidesAndPointToTheSecond) {
    const TetMesh mesh = kuhn_brick(Vec3(4.0, 3.0, 2.0), {3, 2, 2});
    const auto centre = [&](int t) {
        Vec3 sum = Vec3::Zero();
        for (const int v : mesh.tetrahedra[t]) sum += 0.25 * mesh.vertices_mm[v];
        return sum;
    };
    for (const Joint& joint : joints_of(mesh)) {
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(mesh.tetrahedra[joint.tetrahedra[0]][joint.corners[0][k]],
                      mesh.tetrahedra[joint.tetrahedra[1]][joint.corners[1][k]]);
        EXPECT_GT(joint.normal.dot(centre(joint.tetrahedra[1]) - centre(joint.tetrahedra[0])), 0.0);
        EXPECT_NEAR(joint.normal.norm(), 1.0, 1e-14);
    }
}

// The nodal forces of a uniform stress P are -V P grad N_a; grad N_a is minus the area vector of
// the opposite face over 3 V.
TEST(Stress, OfTheForcesOfAUniformStressIsThatStress) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int trial = 0; trial < 20; ++trial) {
        std::array<Vec3, 4> x;
        for (Vec3& p : x) p = Vec3(any(random), any(random), any(random)) + Vec3(100, 50, -20);
        if (signed_volume_mm3(x[0], x[1], x[2], x[3]) < 0.0) std::swap(x[0], x[1]);
        const double volume = signed_volume_mm3(x[0], x[1], x[2], x[3]);
        Mat3 stress;
        for (int i = 0; i < 9; ++i) stress(i) = 1e5 * any(random);
        std::array<small::Vector3<double>, 4> force, from_first;
        constexpr int faces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
        for (int a = 0; a < 4; ++a) {
            const auto& f = faces[a];
            const Vec3 area = 0.5 * (x[f[1]] - x[f[0]]).cross(x[f[2]] - x[f[0]]);
            force[a] = small::from_eigen(Vec3(stress * area / 3.0));  // -V P (-area / 3 V)
            from_first[a] = small::from_eigen(Vec3(x[a] - x[0]));
        }
        EXPECT_LT((small::to_eigen(stress_of(force, from_first, volume)) - stress).norm(),
                  1e-9 * stress.norm());
    }
}

TEST(EffectiveTraction, CountsPullAndShearButNoPressure) {
    const Vec3 n = Vec3::UnitX();
    EXPECT_DOUBLE_EQ(effective_traction_pa(Vec3(5, 0, 0), n), 5.0);
    EXPECT_DOUBLE_EQ(effective_traction_pa(Vec3(3, 4, 0), n), 5.0);
    EXPECT_DOUBLE_EQ(effective_traction_pa(Vec3(-3, 4, 0), n), 4.0);
    EXPECT_DOUBLE_EQ(effective_traction_pa(Vec3(-3, 0, 0), n), 0.0);
}

}  // namespace
}  // namespace hepatica
