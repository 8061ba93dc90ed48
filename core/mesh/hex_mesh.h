// SPDX-License-Identifier: GPL-3.0-or-later
// A body as hexahedra with eight corners. Plain data.
#pragma once

#include <array>
#include <vector>

#include "core/base/vector.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

// Corners in VTK's order: 0-3 counter-clockwise around the bottom, seen from above, 4-7 above them.
struct HexMesh {
    std::vector<Vec3> vertices_mm;
    std::vector<std::array<int, 8>> hexahedra;
};

// Six tetrahedra per hexahedron, around the diagonal from corner 0 to corner 6 (Kuhn 1960). They
// conform where neighbours are numbered alike, as in a brick. For surfaces and skeletons.
std::vector<std::array<int, 4>> cut_into_tetrahedra(
    const std::vector<std::array<int, 8>>& hexahedra);

}  // namespace hepatica
