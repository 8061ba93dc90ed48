// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a CT that vessels are looked for in: the closed liver with a margin, on cubic voxels.
// Intensities are resampled, never masks of vessels: slices of 3 mm break thin branches otherwise.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct LiverFrame {
    FloatVolume intensity;  // HU
    Mask liver;             // closed; same grid
};

// spacing_mm: edge of the cubes, 0.3 to 1.5. `liver` may lie on any grid. Throws InputError where
// liver and CT do not overlap or the spacing is outside its range; Cancelled.
LiverFrame make_liver_frame(const Volume& ct, const Mask& liver, double spacing_mm, Job& job);

}  // namespace hepatica
