// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes of regular elements: bodies for tests, benchmarks and the trade-off, with known exact
// solutions.
#pragma once

#include "core/base/vector.h"
#include "core/mesh/hex_mesh.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

// The box [0, size] in cells of equal size, each cut into six tetrahedra around its main diagonal
// (Kuhn 1960); they conform from cell to cell. Vertices run fastest along x, then y, then z. Throws
// InputError unless size_mm is positive and finite and cells >= 1 along every axis.
TetMesh kuhn_brick(const Vec3& size_mm, const Index3& cells);

// The same box as one hexahedron per cell, with the same vertices and errors.
HexMesh hexahedral_brick(const Vec3& size_mm, const Index3& cells);

}  // namespace hepatica
