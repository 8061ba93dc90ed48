// SPDX-License-Identifier: GPL-3.0-or-later
// The closed surface where a field of voxels is a half, by surface nets (Gibson 1998): a vertex in
// every cell that it passes, a quadrangle across every edge between voxels that it cuts. Most of
// its triangles are about as large as cells, which suits contact.
#pragma once

#include "core/image/volume.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

// In mm, counter-clockwise from outside, which is where the field is less than a half; empty where
// it is so everywhere. Voxels on the border are outside. May touch itself along an edge.
TriangleMesh level_surface(const FloatVolume& share);

}  // namespace hepatica
