// SPDX-License-Identifier: GPL-3.0-or-later
// Divides the liver into Couinaud's segments by the portal vein: every voxel belongs to the segment
// whose branch is nearest by the shortest path through the liver (Selle et al., IEEE Trans Med
// Imaging 2002;21:1344, who use straight lines).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/job.h"
#include "core/image/volume.h"
#include "core/tree/territories/couinaud_branches.h"

namespace hepatica {

struct LabelledPortalVein {
    CouinaudFrame frame;
    std::vector<BranchLabel> branches;  // one per segment of the tree
};

// Labels the branches. None where the tree has no portal vein or `liver` is empty. Linear in the
// liver's voxels.
std::optional<LabelledPortalVein> label_portal_vein(const VesselTree& tree, const Mask& liver);

struct CouinaudSegments : LabelledPortalVein {
    Mask labels;  // 1 to 8, on the liver's grid; 0 outside the liver
    // Share of the liver's volume nearest to branches whose label is less than 80 % certain.
    double unsure_share = 0.0;
};

// None as above. Every voxel of the liver gets the label of a branch, so a segment without a branch
// gets no voxels. The same bytes for any number of threads. Reports progress in the present stage;
// throws Cancelled.
std::optional<CouinaudSegments> couinaud_segments(const VesselTree& tree, const Mask& liver,
                                                  Job& job);

// Volumes in ml of labels 1 to 8 (index 0 to 7).
std::array<double, couinaud_count> segment_volumes_ml(const Mask& labels);

}  // namespace hepatica
