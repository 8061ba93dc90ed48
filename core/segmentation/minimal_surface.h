// SPDX-License-Identifier: GPL-3.0-or-later
// The wall of a vessel as a surface of least area that parts bright from dark: the convex two-phase
// segmentation of Chan, Esedoglu and Nikolova (2006), solved by Chambolle and Pock (2011).
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct SurfaceOptions {
    // The wall runs where the intensity has fallen to this share of the vessel's own peak. Half is
    // right for wide vessels, more for those as thin as the blur; experts draw walls at 0.32 of the
    // rise (docs/accuracy.md).
    double level_share = 0.39;
    // Minimising the area moves the wall inwards, as if the level were this many deviations higher.
    // The level is lowered by as much.
    double pull_deviations = 0.7;
    double peak_reach_mm = 2.4;     // how far around a voxel its vessel's peak is looked for
    double least_deviations = 1.6;  // the level is never below this multiple of the deviation
    double data_weight = 0.6;       // of one deviation against one voxel face of surface
    int iterations = 40;
};

// The vessels again, with their surface moved by up to one voxel outwards or any way inwards so
// that it minimises area + data_weight * sum of (level - intensity) / deviation over the inside.
// `intensity` is little smoothed, `rise` is smooth enough for its peaks to be trusted (both in HU
// above the tissue); `deviation` is the noise of `rise`. All on one grid of cubes. Thin vessels may
// break: rejoin() in vessel_growth.h mends that. Throws Cancelled.
Mask fit_surface(const FloatVolume& intensity, const FloatVolume& rise, const Mask& vessels,
                 const Mask& liver, double deviation, const SurfaceOptions& options, Job& job);

}  // namespace hepatica
