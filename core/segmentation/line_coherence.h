// SPDX-License-Identifier: GPL-3.0-or-later
// Brightness along a line. A thin vessel differs from noise not by its peak but by continuing in
// one direction and its opposite, gently bent.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct LineOptions {
    double half_length_mm = 3.5;
    int directions = 60;       // spread evenly over the sphere
    double max_bend_deg = 37;  // between one half and the straight continuation of the other
};

// For every candidate voxel the largest mean of the values along two half-lines that leave it in
// nearly opposite directions (the voxel included), in the unit of `values`; 0 elsewhere. Outside
// the grid the border value is repeated. Voxels must be cubes, both images on one grid. Throws
// Cancelled.
FloatVolume line_coherence(const FloatVolume& values, const Mask& candidates,
                           const LineOptions& options, Job& job);

}  // namespace hepatica
