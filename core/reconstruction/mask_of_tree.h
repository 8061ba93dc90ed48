// SPDX-License-Identifier: GPL-3.0-or-later
// Voxels that follow the tree: what no seed reached may have been joined to a system by a bridge,
// or left out.
#pragma once

#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Gives each 26-connected piece of voxels of an unknown system the system that most centreline
// points of the tree in it have. Pieces without any centreline become background where `only_tree`
// is set. Returns whether a voxel became background.
bool follow_tree(Mask& mask, const VesselTree& tree, bool only_tree);

}  // namespace hepatica
