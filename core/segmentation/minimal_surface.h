// SPDX-License-Identifier: GPL-3.0-or-later
// The wall of a vessel as a surface of least area that separates bright from dark: the convex
// two-phase segmentation of Chan, Esedoglu and Nikolova (2006), solved by Chambolle and Pock
// (2011).
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct SurfaceOptions {
    // The wall lies where the intensity has fallen to this share of the vessel's own peak. 0.5 is
    // right for wide vessels, more for those as thin as the blur; experts draw walls at 0.32 of the
    // rise (docs/accuracy.md).
    double level_share = 0.39;
    // Minimising the area moves the wall inwards, as if the level were this many deviations higher;
    // the level is lowered by as much.
    double pull_deviations = 0.7;
    double peak_reach_mm = 2.4;     // radius around a voxel in which its vessel's peak is sought
    double least_deviations = 1.6;  // the level is never below this multiple of the deviation
    double data_weight = 0.6;       // of one deviation, relative to one voxel face of surface
    int iterations = 40;
};

// The vessels with their surface moved, by up to one voxel outwards and any distance inwards, so
// that it minimises area + data_weight * sum over the inside of (level - intensity) / deviation,
// with the area in voxel faces. `intensity` is lightly smoothed; `rise` is smooth enough for its
// peaks to be reliable (both in HU above the tissue); `deviation` (> 0) is the noise of `rise`. All
// on one grid of cubes; voxels outside `liver` are dropped. Thin vessels may break: rejoin() in
// vessel_growth.h repairs that. Throws Cancelled.
Mask fit_surface(const FloatVolume& intensity, const FloatVolume& rise, const Mask& vessels,
                 const Mask& liver, double deviation, const SurfaceOptions& options, Job& job);

}  // namespace hepatica
