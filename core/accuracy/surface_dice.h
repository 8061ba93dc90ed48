// SPDX-License-Identifier: GPL-3.0-or-later
// Surface Dice of two masks (Nikolov et al., J Med Internet Res 2021;23:e26151) on border voxels,
// each weighted by the area of its faces next to background.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Area of both surfaces that has the other surface within tolerance_mm (between centres of border
// voxels), divided by the whole area of both; only where `judged` is not zero. 1 where there is no
// surface. The three masks share one grid; outside it is background. Throws Cancelled.
double surface_dice(const Mask& a, const Mask& b, const Mask& judged, double tolerance_mm,
                    Job& job);

}  // namespace hepatica
