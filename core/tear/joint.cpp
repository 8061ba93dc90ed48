// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tear/joint.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hepatica {
namespace {

struct Face {
    std::array<int, 3> vertices{};  // ascending
    int tetrahedron = 0;
    int opposite = 0;  // corner
};

Joint joint_between(const TetMesh& mesh, const Face& first, const Face& second) {
    Joint joint;
    joint.tetrahedra = {first.tetrahedron, second.tetrahedron};
    joint.corners[0] = face_corners[first.opposite];
    const auto& one = mesh.tetrahedra[first.tetrahedron];
    const auto& other = mesh.tetrahedra[second.tetrahedron];
    std::array<Vec3, 3> x;
    for (int k = 0; k < 3; ++k) {
        const int vertex = one[joint.corners[0][k]];
        joint.corners[1][k] = static_cast<int>(std::ranges::find(other, vertex) - other.begin());
        x[k] = mesh.vertices_mm[vertex];
    }
    const Vec3 doubled = (x[1] - x[0]).cross(x[2] - x[0]);
    joint.area_mm2 = 0.5 * doubled.norm();
    joint.normal = doubled.normalized();
    joint.centre_mm = (x[0] + x[1] + x[2]) / 3.0;
    return joint;
}

}  // namespace

std::vector<Joint> joints_of(const TetMesh& mesh) {
    std::vector<Face> faces;
    faces.reserve(4 * mesh.tetrahedra.size());
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        for (int i = 0; i < 4; ++i) {
            Face face{{}, static_cast<int>(t), i};
            for (int k = 0; k < 3; ++k) face.vertices[k] = mesh.tetrahedra[t][face_corners[i][k]];
            std::ranges::sort(face.vertices);
            faces.push_back(face);
        }
    std::ranges::sort(faces, {},
                      [](const Face& face) { return std::pair(face.vertices, face.tetrahedron); });
    std::vector<Joint> joints;
    for (std::size_t i = 0; i + 1 < faces.size(); ++i)
        if (faces[i].vertices == faces[i + 1].vertices)
            joints.push_back(joint_between(mesh, faces[i], faces[i + 1]));
    return joints;
}

Vec3 traction_on(const Joint& joint, const Mat3& first_stress_pa, const Mat3& second_stress_pa) {
    return 0.5 * (first_stress_pa + second_stress_pa) * joint.normal;
}

double effective_traction_pa(const Vec3& traction_pa, const Vec3& present_normal) {
    const double along = traction_pa.dot(present_normal);
    const Vec3 across = traction_pa - along * present_normal;
    const double pull = std::max(along, 0.0);
    return std::sqrt(pull * pull + across.squaredNorm());
}

}  // namespace hepatica
