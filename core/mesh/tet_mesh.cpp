// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes, boundary faces by sorting, and validation.
#include "core/mesh/tet_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace hepatica {

// Positive for a right-handed tetrahedron.
double signed_volume_mm3(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a) / 6.0;
}

double volume_mm3(const TetMesh& mesh) {
    double volume = 0.0;
    for (const auto& [a, b, c, d] : mesh.tetrahedra)
        volume += signed_volume_mm3(mesh.vertices_mm[a], mesh.vertices_mm[b], mesh.vertices_mm[c],
                                    mesh.vertices_mm[d]);
    return volume;
}

std::vector<std::array<int, 3>> boundary_triangles(const TetMesh& mesh) {
    struct Face {
        std::array<int, 3> sorted;
        std::array<int, 3> outward;
        std::size_t order;
    };
    std::vector<Face> faces;
    faces.reserve(4 * mesh.tetrahedra.size());
    for (const auto& [a, b, c, d] : mesh.tetrahedra) {
        for (const std::array<int, 3>& outward :
             {std::array{b, c, d}, std::array{a, d, c}, std::array{a, b, d}, std::array{a, c, b}}) {
            std::array<int, 3> sorted = outward;
            std::ranges::sort(sorted);
            faces.push_back({sorted, outward, faces.size()});
        }
    }
    std::ranges::sort(faces, [](const Face& p, const Face& q) {
        return p.sorted != q.sorted ? p.sorted < q.sorted : p.order < q.order;
    });
    std::vector<Face> single;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t j = i + 1;
        while (j < faces.size() && faces[j].sorted == faces[i].sorted) ++j;
        if (j == i + 1) single.push_back(faces[i]);
        i = j;
    }
    std::ranges::sort(single, {}, &Face::order);
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(single.size());
    for (const Face& face : single) triangles.push_back(face.outward);
    return triangles;
}

void validate(const TetMesh& mesh) {
    const int vertices = static_cast<int>(mesh.vertices_mm.size());
    const auto reject = [](const std::string& problem, const std::string& place) {
        throw InputError(problem, place, "The mesh is damaged; reconstruct the patient again");
    };
    for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v)
        if (!mesh.vertices_mm[v].allFinite())
            reject("is not finite", "vertex " + std::to_string(v));
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const auto& [a, b, c, d] = mesh.tetrahedra[t];
        for (const int v : mesh.tetrahedra[t])
            if (v < 0 || v >= vertices)
                reject("names vertex " + std::to_string(v) + ", which does not exist",
                       "tetrahedron " + std::to_string(t));
        const double volume = signed_volume_mm3(mesh.vertices_mm[a], mesh.vertices_mm[b],
                                                mesh.vertices_mm[c], mesh.vertices_mm[d]);
        if (!(volume > 0.0))
            reject("is flat or inverted (volume " + number_text(volume) + " mm3)",
                   "tetrahedron " + std::to_string(t));
    }
}

}  // namespace hepatica
