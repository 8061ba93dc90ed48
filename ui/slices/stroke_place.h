// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a stroke of the vessels' brush lies where no vessel of the liver can be.
#pragma once

#include "core/image/brush.h"
#include "core/image/volume.h"

namespace hepatica {

// No voxel of the liver lies within 25 mm of the stroke's ball, wherever it was led: portal trunk
// and hepatic veins reach that far outside. `organs` are labels of a case; where they know no
// liver, no stroke is far from it.
bool lies_far_outside(const BrushStroke& stroke, const Mask& organs);

}  // namespace hepatica
