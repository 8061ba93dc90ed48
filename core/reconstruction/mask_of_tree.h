// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the voxels of the vessels agree with the tree after its systems were told apart or a bridge
// joined a piece to a system.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Gives voxels the systems of the tree. Where `anew` is set, every voxel takes the system of the
// centreline that is nearest along the vessels (vessel_systems.h). Then each 26-connected piece of
// voxels of an unknown system takes the system of most centreline points in it; pieces without
// centrelines stay unknown. `left_out` are points on centrelines that were removed from the tree;
// they count like the others. Throws Cancelled.
void follow_tree(Mask& mask, const VesselTree& tree, bool anew, Job& job,
                 const std::vector<VesselSeed>& left_out = {});

}  // namespace hepatica
