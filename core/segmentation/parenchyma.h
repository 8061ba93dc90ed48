// SPDX-License-Identifier: GPL-3.0-or-later
// The parenchyma of the liver, grown from where it is deepest: intensity is compared with that of
// the parenchyma near by, so that a field of contrast or the streaks of the arms are followed, and
// nothing is passed that is narrower than the neck between two organs.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct Parenchyma {
    Mask voxels;          // one piece, vessels and tumours left out
    FloatVolume hu;       // what the parenchyma has near each voxel
    FloatVolume support;  // 0 to 1: share of parenchyma near each voxel, by which `hu` is trusted
    double spread_hu = 0.0;  // 7 to 9: deviation of its voxels from `hu`
};

// The deepest part of an organ: what hangs together at half of its greatest depth, grown back by as
// much. `core`: one piece, not empty; all of it where it fills the image. Throws Cancelled.
Mask seat_of(const Mask& core, Job& job);

// `smooth` is a scan of about 3 mm, smoothed by 2 mm; `seat` on its grid, not empty. Throws
// Cancelled.
Parenchyma grow_parenchyma(const FloatVolume& smooth, const Mask& seat, Job& job);

}  // namespace hepatica
