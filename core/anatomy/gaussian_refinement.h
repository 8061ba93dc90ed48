// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's first round of refinement (section II.A.2): a recursive 3-D Gaussian that smooths the
// surface of the reconstructed volume. The number of recursions is the level of refinement.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct RefinementOptions {
    int recursions = 1;     // 0 returns the mask unchanged
    double sigma_mm = 0.6;  // of each recursion; n recursions act as sqrt(n) sigma_mm
    // The level set of the smoothed volume that becomes the new surface. At 0.5 a cylinder of
    // radius R shrinks by about n sigma^2 / (2 R): thin branches vanish first, as the paper says.
    double level = 0.5;
    // Keeps every voxel of the centreline that the level set would lose, so that a thin branch
    // stays connected.
    bool keep_thin_branches = true;
};

// Same grid. Labels (several systems) are kept: a voxel that joins takes the label of the nearest
// object voxel. Throws InputError for a negative number of recursions or sigma_mm <= 0; Cancelled.
Mask refine(const Mask& mask, const RefinementOptions& options, Job& job);
Mask refine(const Mask& mask, int recursions, Job& job);

// How rough a surface is: area of the voxel surface, estimated by Cauchy-Crofton counting of
// crossings along 13 directions, in square millimetres. Volume in cubic millimetres.
struct SurfaceMeasure {
    double area_mm2 = 0.0;
    double volume_mm3 = 0.0;
};
SurfaceMeasure measure_surface(const Mask& mask);

}  // namespace hepatica
