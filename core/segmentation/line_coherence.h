// SPDX-License-Identifier: GPL-3.0-or-later
// Bright along a line: what tells a thin vessel from noise is not its peak but that the brightness
// goes on in one direction and its opposite, gently bent.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct LineOptions {
    double half_length_mm = 3.5;
    int directions = 60;       // spread evenly over the sphere
    double max_bend_deg = 37;  // between one half of the line and the straight continuation
};

// For every candidate voxel the largest mean of the values along two half-lines that leave it in
// nearly opposite directions; 0 elsewhere. Outside the grid the border value continues. The voxels
// must be cubes. Throws Cancelled.
FloatVolume line_coherence(const FloatVolume& values, const Mask& candidates,
                           const LineOptions& options, Job& job);

}  // namespace hepatica
