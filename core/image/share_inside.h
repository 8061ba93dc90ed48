// SPDX-License-Identifier: GPL-3.0-or-later
// Voxels as a smooth field, whose level of a half is the surface of what they show.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// 1 where `part` is not 0 and 0 elsewhere, smoothed by a Gaussian of smoothing_mm >= 0 along each
// axis, on a grid of this spacing (all > 0). Throws Cancelled.
FloatVolume share_inside(const Mask& part, double smoothing_mm, const Vec3& spacing_mm, Job& job);

// The same volume with a layer of zeros around it, so that every surface in it is closed.
FloatVolume with_border(const FloatVolume& inner);

}  // namespace hepatica
