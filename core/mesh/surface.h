// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a body as a triangle mesh of its own, and tests of surfaces.
#pragma once

#include <vector>

#include "core/mesh/tet_mesh.h"

namespace hepatica {

struct BodySurface {
    TriangleMesh mesh;             // only the vertices on the boundary, in their order
    std::vector<int> body_vertex;  // per vertex of `mesh`: its index in the body
};

BodySurface surface_of(const TetMesh& body);

// Whether every edge lies between exactly two triangles with opposite directions, and the triangles
// around each vertex form one fan. Indices must be valid.
bool is_closed_manifold(const TriangleMesh& surface);

// Throws InputError, naming the edge, if the surface is not closed and consistently oriented, if a
// triangle names a vertex twice, or if an index is invalid. A surface that touches itself along an
// edge counts as closed.
void validate_closed(const TriangleMesh& surface);

}  // namespace hepatica
