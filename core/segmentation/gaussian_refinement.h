// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's first round of refinement (section II.A.2): a recursive 3-D Gaussian smooths the
// surface of the reconstructed volume. The number of recursions is the level of refinement.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct RefinementOptions {
    int recursions = 1;     // 0 returns the mask unchanged
    double sigma_mm = 0.5;  // of each recursion; n of them act as one of sqrt(n) sigma_mm
    // The level of the smoothed volume at which the new surface lies. At 0.5 a ball of radius R
    // shrinks by about n sigma_mm^2 / R and a cylinder by half of that, so thin branches lose most.
    double level = 0.5;
    // If set, the skeleton of a branch is put back where the level set would cut the branch in two,
    // or would shorten it by more than kept_branch_mm.
    bool keep_thin_branches = true;
    double kept_branch_mm = 4.0;
};

// The refined mask on the same grid. Labels (several systems) are kept: a new voxel takes a
// neighbour's label. Throws InputError for a negative number of recursions, sigma_mm <= 0 or a
// level outside (0, 1); Cancelled.
Mask refine(const Mask& mask, const RefinementOptions& options, Job& job);
Mask refine(const Mask& mask, int recursions, Job& job);

// For the roughness of a surface: its area by the Cauchy-Crofton formula (crossings counted along
// the 13 axes between neighbours, weighted by their share of the sphere; within 2 % on a ball of 8
// voxels radius), and the volume inside.
struct SurfaceMeasure {
    double area_mm2 = 0.0;
    double volume_mm3 = 0.0;
};
SurfaceMeasure measure_surface(const Mask& mask);

}  // namespace hepatica
