// SPDX-License-Identifier: GPL-3.0-or-later
// What rises above the liver's own tissue: the parenchyma is uneven (perfusion, beam hardening,
// fat), so its level is measured around every voxel before anything is called bright.
#pragma once

#include <optional>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct TissueContrast {
    FloatVolume excess;          // intensity minus the local parenchyma, in HU; 0 outside the liver
    double parenchyma_hu = 0.0;  // median over the liver
    double noise_hu = 0.0;       // standard deviation of the parenchyma around its local level
    Mask interior;               // the liver without its outermost 3 mm, where fat shines in
    // What counts as vessel, where the user has said so; else it follows from the noise.
    std::optional<double> threshold_hu;
};

// The local level is a mean over about 8 mm of what differs from it by less than two standard
// deviations (so that vessels and tumours do not count), found by iteration. Robust statistics
// throughout: medians, not means. Throws InputError where the liver is empty; Cancelled.
TissueContrast measure_tissue(const FloatVolume& intensity, const Mask& liver, Job& job);

// Over the object voxels of a mask: the median, and the standard deviation of the noise, estimated
// from the lower half alone (1.4826 times the median distance below the median), because vessels
// only add to the upper half.
struct RobustSpread {
    double median = 0.0;
    double deviation = 0.0;
};
RobustSpread robust_spread(const FloatVolume& values, const Mask& where, const Job& job = Job());

}  // namespace hepatica
