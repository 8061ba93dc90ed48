// SPDX-License-Identifier: GPL-3.0-or-later
// Which branches feed a tumour: those whose territory, by travel through the liver
// (nearest_branch.h), the tumour lies in.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct Feeder {
    int segment = -1;  // of the tree
    VascularSystem system = VascularSystem::portal;
    double share = 0.0;  // of the tumour's voxels; those of one system sum to 1
};

// Feeders of each tumour, portal branches before arterial ones and great shares first; a system
// that the tree does not hold feeds nothing.
//   liver: object voxels are what blood gets through, tumours included.
//   tumours: labels on the liver's grid; the answer has one list for each of `wanted`, in order.
// Throws Cancelled. Reports progress in the present stage, once a system.
std::vector<std::vector<Feeder>> feeders_of(const VesselTree& tree, const Mask& liver,
                                            const Mask& tumours,
                                            const std::vector<std::uint8_t>& wanted, Job& job);

}  // namespace hepatica
