// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a CT in which vessels are sought: the closed liver with a margin, on cubic voxels.
// Intensities are resampled, not vessel masks: in 3 mm slices a mask would break thin branches.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct LiverFrame {
    FloatVolume intensity;  // HU
    Mask liver;             // closed; same grid
};

// spacing_mm: edge of the cubes, 0.3 to 1.5. `liver` may lie on any grid, such as one cut to the
// liver; beyond that grid there is none. Throws InputError where the mask is empty, liver and CT do
// not overlap, the spacing is out of range or the memory is too small for the steps that follow;
// Cancelled.
LiverFrame make_liver_frame(const Volume& ct, const Mask& liver, double spacing_mm, Job& job);

}  // namespace hepatica
