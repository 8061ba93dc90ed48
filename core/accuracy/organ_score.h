// SPDX-License-Identifier: GPL-3.0-or-later
// Agreement of a found organ with an expert's: overlap, share outside the expert's, share missed,
// and mean distance between the surfaces.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct OrganScore {
    double dice = 0.0;             // 1 where both are empty
    double outside_share = 0.0;    // of the found organ, outside the true one
    double missed_share = 0.0;     // of the true organ
    double surface_mean_mm = 0.0;  // symmetric mean over the border voxels of both
};

// Both masks share one grid; 0 is background. Shares of nothing are 0; surface_mean_mm is 0 where
// one mask has no surface, because it is empty or fills the image. Throws Cancelled.
OrganScore organ_score(const Mask& found, const Mask& truth, Job& job);

}  // namespace hepatica
