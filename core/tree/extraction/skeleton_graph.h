// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a unit-width skeleton into a graph of voxel paths: every run of voxels of degree 2 is a
// link; every end, and every 26-connected cluster of voxels of higher degree, is a node.
#pragma once

#include "core/image/volume.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Points are voxel centres (a cluster's node lies at the mean of its voxels). Radii are those of
// the largest ball around a voxel without background of `vessels`, at least a quarter of the
// smallest spacing: exact to about half a voxel, enough for pruning. Isolated voxels are left out.
// Both masks share one grid.
VesselGraph skeleton_graph(const Mask& skeleton, const Mask& vessels);

}  // namespace hepatica
