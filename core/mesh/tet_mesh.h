// SPDX-License-Identifier: GPL-3.0-or-later
// A body as linear tetrahedra, and its boundary. Plain data.
#pragma once

#include <array>
#include <vector>

#include "core/base/vector.h"

namespace hepatica {

// Vertex order is right-handed: (b-a) x (c-a) . (d-a) > 0 for a tetrahedron (a, b, c, d).
struct TetMesh {
    std::vector<Vec3> vertices_mm;
    std::vector<std::array<int, 4>> tetrahedra;
};

// Triangles are counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<Vec3> vertices_mm;
    std::vector<std::array<int, 3>> triangles;
};

double signed_volume_mm3(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
double volume_mm3(const TetMesh& mesh);

// Faces that belong to one tetrahedron only, counter-clockwise seen from outside, in the order of
// the tetrahedra. Indices are those of mesh.vertices_mm.
std::vector<std::array<int, 3>> boundary_triangles(const TetMesh& mesh);

// Checks indices, finite positions and orientation; throws InputError that names the tetrahedron.
// Flat or inverted tetrahedra are rejected with their number and volume.
void validate(const TetMesh& mesh);

}  // namespace hepatica
