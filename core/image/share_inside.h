// SPDX-License-Identifier: GPL-3.0-or-later
// A mask as a smooth field whose isosurface at one half is the surface of the object.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The indicator function of `part` (1 where it is not 0), smoothed by a Gaussian of smoothing_mm >=
// 0 along each axis, on a grid of this spacing (all > 0). Throws Cancelled.
FloatVolume share_inside(const Mask& part, double smoothing_mm, const Vec3& spacing_mm, Job& job);

// The same volume with a layer of zeros around it, so that every isosurface in it is closed.
FloatVolume with_border(const FloatVolume& inner);

}  // namespace hepatica
