// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes cut into regular elements: the bodies of tests, benchmarks and the trade-off, whose exact
// answers are known.
#pragma once

#include "core/base/vector.h"
#include "core/mesh/hex_mesh.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

// The box [0, size] in cells of equal size, each cut into six tetrahedra around its main diagonal
// (Kuhn 1960), which conform from cell to cell. Vertices run fastest along x, then y, then z.
// size_mm > 0 and cells >= 1 in every direction, otherwise InputError.
TetMesh kuhn_brick(const Vec3& size_mm, const Index3& cells);

// The same box as one hexahedron a cell; the same vertices.
HexMesh hexahedral_brick(const Vec3& size_mm, const Index3& cells);

// The box bent into an arc of the given angle (radians, > 0) around an axis along z beside it; the
// length along the middle stays. For slender curved bodies.
void bend_along_x(std::vector<Vec3>& vertices_mm, double length_mm, double middle_y_mm,
                  double angle_rad);

}  // namespace hepatica
