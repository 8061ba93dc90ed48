// SPDX-License-Identifier: GPL-3.0-or-later
// A joint is the face that two tetrahedra share: where a body may tear (section II.C.2 of the
// paper). Its load is the traction of the mean stress of both, relative to the strength of the
// tissue.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/small_matrix.h"
#include "core/base/vector.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

// Corners of the face opposite each corner of a tetrahedron, counter-clockwise seen from outside.
inline constexpr std::array<std::array<int, 3>, 4> face_corners{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

struct Joint {
    std::array<int, 2> tetrahedra{};
    // The corners of each tetrahedron on the joint; corner k of both was the same vertex before
    // anything tore. Counter-clockwise seen from the second tetrahedron.
    std::array<std::array<int, 3>, 2> corners{};
    double area_mm2 = 0.0;       // at rest
    Vec3 normal = Vec3::Zero();  // at rest, of length 1, from the first tetrahedron to the second
    Vec3 centre_mm = Vec3::Zero();  // at rest
};

// All joints of a mesh, ordered by the vertices of their faces. Costs a sort of all faces.
std::vector<Joint> joints_of(const TetMesh& mesh);

// The first Piola-Kirchhoff stress [Pa] of a linear tetrahedron, from the elastic forces [uN] on
// its corners, their places at rest relative to the first corner [mm] and its rest volume [mm3]:
// -sum f_a X_a^T / V. Exact for every law whose forces follow from a constant deformation gradient,
// otherwise an average. T may hold several tetrahedra (elements/lanes.h).
template <class T>
small::Matrix3<T> stress_of(const std::array<small::Vector3<T>, 4>& force_un,
                            const std::array<small::Vector3<T>, 4>& rest_mm, const T& volume_mm3) {
    small::Matrix3<T> stress;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            T sum(0.0);
            for (int a = 1; a < 4; ++a) sum = sum + force_un[a][i] * rest_mm[a][j];
            stress(i, j) = sum / -volume_mm3;
        }
    return stress;
}

// Traction on the joint per rest area [Pa], from the mean stress of its two tetrahedra.
Vec3 traction_on(const Joint& joint, const Mat3& first_stress_pa, const Mat3& second_stress_pa);

// sqrt(<t_n>^2 + |t_s|^2), where t_n is the traction along the present normal, which counts only in
// tension, and t_s the shear traction. A compressed joint fails by shear alone.
double effective_traction_pa(const Vec3& traction_pa, const Vec3& present_normal);

}  // namespace hepatica
