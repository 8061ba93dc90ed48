// SPDX-License-Identifier: GPL-3.0-or-later
// How well an organ that the program found agrees with that of an expert: overlap, what lies
// outside of the expert's, what was missed, and how far apart the two surfaces are.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct OrganScore {
    double dice = 0.0;             // 1 where both are empty
    double outside_share = 0.0;    // of the found organ, outside of the true one
    double missed_share = 0.0;     // of the true organ
    double surface_mean_mm = 0.0;  // from each surface to the other, over both surfaces' voxels
};

// Both on one grid, 0 outside. Shares of nothing are 0; surface_mean_mm is 0 where one of them is
// empty. Throws Cancelled.
OrganScore organ_score(const Mask& found, const Mask& truth, Job& job);

}  // namespace hepatica
