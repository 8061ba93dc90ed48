// SPDX-License-Identifier: GPL-3.0-or-later
// The volume inside a closed surface, by the divergence theorem.
#pragma once

#include "core/mesh/tet_mesh.h"

namespace hepatica::test {

// Positive if the surface is oriented outwards.
inline double enclosed_volume_mm3(const TriangleMesh& surface) {
    double volume = 0.0;
    for (const auto& [a, b, c] : surface.triangles)
        volume += surface.vertices_mm[a].cross(surface.vertices_mm[b]).dot(surface.vertices_mm[c]);
    return volume / 6.0;
}

}  // namespace hepatica::test
