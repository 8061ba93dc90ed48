// SPDX-License-Identifier: GPL-3.0-or-later
// The closed surface where a field of voxels is one half, by surface nets (Gibson 1998): a vertex
// in every cell that the surface passes, a quadrangle across every voxel edge that it cuts. Most of
// its triangles are about as large as the cells, which suits contact.
#pragma once

#include "core/image/volume.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

// In mm, counter-clockwise seen from outside, where the field is less than one half; empty where
// that is everywhere. Border voxels count as outside. The surface may touch itself along an edge.
TriangleMesh level_surface(const FloatVolume& share);

}  // namespace hepatica
