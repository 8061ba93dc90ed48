// SPDX-License-Identifier: GPL-3.0-or-later
// The largest soft organ of a CT: for each peak in the histogram of homogeneous soft tissue, the
// largest piece of its band of intensities after narrow necks are cut; the largest of all wins.
#pragma once

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

// The range of intensities of soft organs.
constexpr double soft_organ_from_hu = 30.0;
constexpr double soft_organ_to_hu = 250.0;

// Mean over blocks of whole voxels of about 3 mm; voxels beyond the last whole block are dropped.
// Throws Cancelled.
FloatVolume coarsened(const Volume& ct, Job& job);

// Length of the gradient by central differences, in HU per mm; at the border of the image the
// component along that axis counts as 0.
float slope_at(const FloatVolume& hu, int x, int y, int z);

struct SoftOrgan {
    double hu = 0.0;            // the peak of the histogram
    double half_band_hu = 0.0;  // 12 to 24: half the width of its band of intensities
    double core_ml = 0.0;       // 0 where the image shows no soft tissue
    Mask core;                  // voxels of the band more than 6 mm from its border; one piece
};

// `smooth` is a scan of about 3 mm spacing, smoothed with a sigma of 3 mm. Throws Cancelled.
SoftOrgan largest_soft_organ(const FloatVolume& smooth, Job& job);

// The organ grown back from its core, with the rim lost to smoothing and with adjacent tissue of
// its intensity, neighbouring organs included. On the grid of `smooth`. Throws Cancelled.
Mask with_all_alike(const SoftOrgan& organ, const FloatVolume& smooth, Job& job);

}  // namespace hepatica
