// SPDX-License-Identifier: GPL-3.0-or-later
// Tissue that an organ encloses but that does not look like it: tumours, cysts and wide vessels in
// a liver.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Voxels of -10 to 250 HU outside `organ` that it encloses: of the rays along the grid's axes and
// diagonals (26 directions, none between them), at least 65 % reach the organ within 60 mm without
// meeting fat (below -40 HU), gas or bone (above 250 HU). A ray that leaves the image does not
// reach it where it runs across the body; where it also runs along the body it is not counted, by
// whichever side it leaves. At least 9 rays must be counted. What is thinner than 8 mm together
// with the organ is left out; a thin piece between walls of the organ stays. `smooth` (HU,
// smoothed) and `organ` lie on the same grid. Throws Cancelled. Thread-safe; the same for any
// number of threads.
Mask enclosed_tissue(const FloatVolume& smooth, const Mask& organ, Job& job);

}  // namespace hepatica
