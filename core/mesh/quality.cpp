// SPDX-License-Identifier: GPL-3.0-or-later
// Dihedral angles from face normals; topology from the Euler characteristic of the boundary.
#include "core/mesh/quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/mesh/surface.h"

namespace hepatica {

namespace {

constexpr double degrees = 180.0 / M_PI;

template <class Cells>
int components_of(std::size_t vertices, const Cells& cells) {
    DisjointSets sets(vertices);
    std::vector<char> used(vertices, 0);
    for (const auto& cell : cells)
        for (const int vertex : cell) {
            used[vertex] = 1;
            sets.unite(static_cast<std::uint32_t>(cell[0]), static_cast<std::uint32_t>(vertex));
        }
    // A vertex without a cell is a set of its own and does not count.
    return static_cast<int>(sets.count()) - static_cast<int>(std::ranges::count(used, 0));
}

}  // namespace

DihedralRange dihedral_angles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    // Outward normals of the faces opposite to a, b, c, d.
    const std::array<Vec3, 4> normals = {
        (c - b).cross(d - b).normalized(), (d - a).cross(c - a).normalized(),
        (b - a).cross(d - a).normalized(), (c - a).cross(b - a).normalized()};
    double least = 1.0, most = -1.0;  // cosines
    for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j) {
            const double cosine = std::clamp(-normals[i].dot(normals[j]), -1.0, 1.0);
            least = std::min(least, cosine);
            most = std::max(most, cosine);
        }
    return {std::acos(most) * degrees, std::acos(least) * degrees};
}

MeshQuality quality_of(const TetMesh& mesh) {
    MeshQuality quality;
    if (mesh.tetrahedra.empty()) return quality;
    quality.min_dihedral_deg = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c, d] : mesh.tetrahedra) {
        const DihedralRange range = dihedral_angles(mesh.vertices_mm[a], mesh.vertices_mm[b],
                                                    mesh.vertices_mm[c], mesh.vertices_mm[d]);
        quality.min_dihedral_deg = std::min(quality.min_dihedral_deg, range.min_deg);
        quality.max_dihedral_deg = std::max(quality.max_dihedral_deg, range.max_deg);
    }
    quality.volume_mm3 = volume_mm3(mesh);
    quality.components = components_of(mesh.vertices_mm.size(), mesh.tetrahedra);
    const TriangleMesh surface = surface_of(mesh).mesh;
    quality.closed = is_closed_manifold(surface);
    quality.boundary_components = components_of(surface.vertices_mm.size(), surface.triangles);
    const auto vertices = static_cast<int>(surface.vertices_mm.size());
    const auto triangles = static_cast<int>(surface.triangles.size());
    const int euler = vertices - triangles / 2;  // V - E + F with E = 3F/2
    quality.handles = quality.boundary_components - euler / 2;
    return quality;
}

}  // namespace hepatica
