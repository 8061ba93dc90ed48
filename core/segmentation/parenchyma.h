// SPDX-License-Identifier: GPL-3.0-or-later
// The parenchyma of the liver, grown from its deepest part. Intensity is compared with that of
// nearby parenchyma, so that uneven contrast and streaks of the arms are followed; growth does not
// pass anything narrower than the neck between two organs.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct Parenchyma {
    Mask voxels;          // around the seat, without vessels and tumours
    FloatVolume hu;       // local mean of the parenchyma around each voxel
    FloatVolume support;  // 0 to 1: share of parenchyma around each voxel, the reliability of `hu`
    double spread_hu = 0.0;  // 7 to 9: standard deviation of its voxels from `hu`
};

// The deepest part of an organ: the connected piece, around the deepest voxel, of what lies at half
// of the greatest depth or more, dilated by that half. `core`: one piece, not empty; returned
// unchanged where it fills the image. Throws Cancelled.
Mask seat_of(const Mask& core, Job& job);

// Grows the parenchyma from `seat` (not empty) in `smooth`, a scan of about 3 mm spacing smoothed
// with a sigma of 2 mm; same grid. At most 12 rounds. Throws Cancelled.
Parenchyma grow_parenchyma(const FloatVolume& smooth, const Mask& seat, Job& job);

}  // namespace hepatica
