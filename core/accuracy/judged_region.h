// SPDX-License-Identifier: GPL-3.0-or-later
// The region in which vascular systems are judged: inside the closed liver and away from the vena
// cava, which experts draw as part of the hepatic veins although it is no vessel of the liver.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct CavaNeighbourhood {
    double radius_mm = 6.0;  // a hepatic lumen with a larger radius is the vena cava
    double reach_mm = 9.0;   // distance excluded around voxels that deep inside it
    double beside_mm = 3.0;  // distance excluded around a separate mask of the cava
};

// 1 near the cava: within reach_mm of voxels that lie deeper than radius_mm below the surface of
// `hepatic`, and within beside_mm of `cava`. Either may be null; those given share one grid. Throws
// Cancelled.
Mask near_cava(const Mask* hepatic, const Mask* cava, const CavaNeighbourhood& size, Job& job);

// 1 in the closed liver (everywhere where `liver` is null) and outside `left_out`, on the grid that
// both share. Throws Cancelled.
Mask judged_region(const Mask* liver, const Mask& left_out, Job& job);

}  // namespace hepatica
