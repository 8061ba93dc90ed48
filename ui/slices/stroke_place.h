// SPDX-License-Identifier: GPL-3.0-or-later
// Tells whether a stroke of the vessel brush lies where no vessel of the liver can be.
#pragma once

#include "core/image/brush.h"
#include "core/image/volume.h"

namespace hepatica {

// True if no voxel of the liver lies within 25 mm of the swept ball, the length by which portal
// trunk and hepatic veins leave the liver. `organs` has the organ labels of a case; false if it has
// no liver voxels.
bool lies_far_outside(const BrushStroke& stroke, const Mask& organs);

}  // namespace hepatica
