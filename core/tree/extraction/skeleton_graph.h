// SPDX-License-Identifier: GPL-3.0-or-later
// From a unit-width skeleton to a graph of voxel paths: every run of voxels of degree 2 is a link,
// every end and every 26-connected cluster of voxels of higher degree is a node.
#pragma once

#include "core/image/volume.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Points are voxel centres in millimetres (a cluster's node stands at the mean of its voxels, or at
// its only voxel). Radii are those of the largest ball around a voxel that holds no background of
// `vessels`, at least a quarter of the smallest voxel spacing: exact to about half a voxel, good
// for pruning. Isolated voxels are left out. Both masks lie on one grid.
VesselGraph skeleton_graph(const Mask& skeleton, const Mask& vessels);

}  // namespace hepatica
