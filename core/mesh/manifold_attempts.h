// SPDX-License-Identifier: GPL-3.0-or-later
// A body's boundary must be a closed manifold: every edge between two triangles, one fan of
// triangles around every vertex. Where two branches nearly touch, refinement may yield a mesh that
// meets itself along an edge; another size of the elements moves every vertex and mends that. What
// no size mends is told to the caller.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/mesh/tet_mesh.h"

namespace hepatica {

struct ManifoldMesh {
    TetMesh mesh;
    bool is_manifold = true;  // false: no attempt was one, and this is the last
};

// Calls mesher(scale) with the sizes of elements scaled by 1, 0.93, 0.86 and 0.8 until the boundary
// is a closed manifold. What the mesher throws passes through.
ManifoldMesh first_manifold(const std::function<TetMesh(double scale)>& mesher);

// Where `unclosed` of `all` bodies are not closed manifolds: adds a sentence for the user to
// `warnings`, or throws InputError where there is nobody to hear it.
void report_unclosed(int unclosed, int all, std::vector<std::string>* warnings);

}  // namespace hepatica
