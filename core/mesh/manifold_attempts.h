// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a body must be a closed manifold: every edge between two triangles, one fan of
// triangles around every vertex. Where two branches nearly touch, refinement may give a mesh that
// meets itself along an edge; another element size moves every vertex and usually resolves that. If
// no size does, the caller is told.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/tet_mesh.h"

namespace hepatica {

// Factors of the element sizes of the attempts, in their order; attempt_sizes() applies them.
inline constexpr std::array attempt_scales{1.0, 0.93, 0.86, 0.8};

struct ManifoldMesh {
    TetMesh mesh;
    bool is_manifold = true;  // false: no attempt gave one, and this is the last
};

// Calls mesher(scale) with each of attempt_scales until the boundary is a closed manifold.
// Exceptions of the mesher pass through.
ManifoldMesh first_manifold(const std::function<TetMesh(double scale)>& mesher);

// If `unclosed` of `all` bodies are not closed manifolds: adds a sentence for the user to
// `warnings`, or throws InputError if that is null.
void report_unclosed(int unclosed, int all, std::vector<std::string>* warnings);

// Whether a warning is such a sentence: it holds for one mesh, and no longer for the next.
bool is_of_unclosed(std::string_view warning);

}  // namespace hepatica
