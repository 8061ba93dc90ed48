// SPDX-License-Identifier: GPL-3.0-or-later
// Tells whether a stroke of a brush lies where no vessel or no tumour of the liver can be, or where
// a case keeps none.
#pragma once

#include "core/image/brush.h"
#include "core/image/volume.h"

namespace hepatica {

// True if no voxel of the liver lies within 25 mm of the swept ball, the length by which portal
// trunk and hepatic veins leave the liver. `organs` has the organ labels of a case; false if it has
// no liver voxels.
bool lies_far_outside(const BrushStroke& stroke, const Mask& organs);

// The same of a stroke that painted a tumour and is in `organs` already: true if within 5 mm of the
// swept ball there is neither liver nor, outside of the ball, a tumour that it could belong to.
bool tumour_lies_outside(const BrushStroke& stroke, const Mask& organs);

// True if the swept ball holds voxels of the CT that lie beyond the canvas of tumours
// (tumour_canvas()) by a quarter of its voxel or more, and so are not painted.
bool tumour_is_cut_off(const BrushStroke& stroke, const Grid& canvas, const Grid& ct);

}  // namespace hepatica
