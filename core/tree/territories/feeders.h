// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the branches that feed a tumour: those whose territory, by shortest paths through the liver
// (nearest_branch.h), it lies in.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct Feeder {
    int segment = -1;  // of the tree
    VascularSystem system = VascularSystem::portal;
    double share = 0.0;  // share of the tumour's voxels; sums to 1 over a system
};

// Feeders of each tumour, portal branches before arterial ones, large shares first; a system that
// the tree does not have feeds nothing.
//   liver: voxels that blood can cross are not 0, tumours included
//   tumours: labels on the liver's grid
//   wanted: labels; the result has one list for each, in this order
// Reports progress in the present stage, once for each system. Throws Cancelled.
std::vector<std::vector<Feeder>> feeders_of(const VesselTree& tree, const Mask& liver,
                                            const Mask& tumours,
                                            const std::vector<std::uint8_t>& wanted, Job& job);

}  // namespace hepatica
