// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a body as a triangle mesh of its own.
#pragma once

#include <vector>

#include "core/mesh/tet_mesh.h"

namespace hepatica {

struct BodySurface {
    TriangleMesh mesh;             // only the vertices that lie on the boundary, in their order
    std::vector<int> body_vertex;  // per vertex of `mesh`: its number in the body
};

BodySurface surface_of(const TetMesh& body);

// Every edge between two triangles with opposite directions, and one fan around each vertex.
bool is_closed_manifold(const TriangleMesh& surface);

// Throws InputError where the surface is not closed and consistently oriented: names the edge. A
// surface that touches itself along an edge is closed.
void validate_closed(const TriangleMesh& surface);

// Volume enclosed by a closed surface, positive if it is oriented outwards.
double enclosed_volume_mm3(const TriangleMesh& surface);

}  // namespace hepatica
