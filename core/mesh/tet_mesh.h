// SPDX-License-Identifier: GPL-3.0-or-later
// A body as linear tetrahedra, and its boundary. Plain data; all functions are thread-safe.
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

// Positive for a right-handed tetrahedron.
double signed_volume_mm3(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
double volume_mm3(const TetMesh& mesh);

// The faces that belong to only one tetrahedron, counter-clockwise seen from outside, in the order
// of the tetrahedra. Indices refer to mesh.vertices_mm.
std::vector<std::array<int, 3>> boundary_triangles(const TetMesh& mesh);

// Throws InputError, naming the vertex or tetrahedron, if an index is invalid, a position is not
// finite, or a tetrahedron is flat or inverted.
void validate(const TetMesh& mesh);

}  // namespace hepatica
