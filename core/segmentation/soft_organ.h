// SPDX-License-Identifier: GPL-3.0-or-later
// The largest soft organ of a CT: the peak of the histogram of homogeneous soft tissue whose voxels
// hold the largest piece that no narrow neck joins to others.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// Where soft organs are looked for.
constexpr double soft_organ_from_hu = 30.0;
constexpr double soft_organ_to_hu = 250.0;

// Mean over blocks of whole voxels of about 3 mm. Throws Cancelled.
FloatVolume coarsened(const Volume& ct, Job& job);

// Length of the gradient by central differences in HU per mm; 0 along an axis on whose border the
// voxel lies.
float slope_at(const FloatVolume& hu, int x, int y, int z);

struct SoftOrgan {
    double hu = 0.0;            // its peak in the histogram
    double half_band_hu = 0.0;  // 12 to 24: half the band of intensities that was taken for it
    double core_ml = 0.0;       // 0 where the image shows no soft tissue
    Mask core;                  // of the band, what is more than 6 mm from its border; one piece
};

// `smooth` is a scan of about 3 mm, smoothed by 3 mm. Throws Cancelled.
SoftOrgan largest_soft_organ(const FloatVolume& smooth, Job& job);

// The organ grown back from its core, with the rim that smoothing took and with whatever of its
// intensity touches it: neighbours among it. On the grid of `smooth`. Throws Cancelled.
Mask with_all_alike(const SoftOrgan& organ, const FloatVolume& smooth, Job& job);

}  // namespace hepatica
