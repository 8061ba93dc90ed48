// SPDX-License-Identifier: GPL-3.0-or-later
// Voxels that follow the tree: systems are told apart on its segments, or a bridge joined a piece
// to one.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Gives voxels the system of the tree: where `anew` is set every voxel that of the centreline that
// is nearest along the vessels (vessel_systems.h); then each 26-connected piece of voxels of an
// unknown system the one that most centreline points in it have. Pieces without any centreline
// stay unknown. Throws Cancelled.
// `left_out` are places on centrelines that the tree lost, which say as much as those that it has.
void follow_tree(Mask& mask, const VesselTree& tree, bool anew, Job& job,
                 const std::vector<VesselSeed>& left_out = {});

}  // namespace hepatica
