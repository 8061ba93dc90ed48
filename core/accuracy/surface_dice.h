// SPDX-License-Identifier: GPL-3.0-or-later
// Share of two masks' surfaces that lie near each other: the surface Dice of Nikolov et al. (J Med
// Internet Res 2021;23:e26151) on border voxels, each weighted by the area of its open faces.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Area of either surface that has the other within tolerance_mm (between centres of border voxels),
// over the area of both; only where `judged` is not zero. 1 where there is no surface at all. The
// three masks share one grid, outside of which is background. Throws Cancelled.
double surface_dice(const Mask& a, const Mask& b, const Mask& judged, double tolerance_mm,
                    Job& job);

}  // namespace hepatica
