// SPDX-License-Identifier: GPL-3.0-or-later
// What an organ encloses without looking like it: tumours, cysts and wide vessels in a liver.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Voxels of -10 to 250 HU outside of `organ` from which at least 65 of 100 ways, along the grid's
// axes and diagonals, reach it within 60 mm and meet no fat, gas or bone before; ways that leave
// the image at its top or bottom are not counted. Pieces thinner than 8 mm are left out. Both on
// one grid. Throws Cancelled.
Mask enclosed_tissue(const FloatVolume& smooth, const Mask& organ, Job& job);

}  // namespace hepatica
