// SPDX-License-Identifier: GPL-3.0-or-later
// The rise of the image above the liver's own tissue. The parenchyma is uneven (perfusion, beam
// hardening, fat), so its level is measured around every voxel before anything is called bright.
#pragma once

#include <optional>

#include "core/base/job.h"
#include "core/image/volume.h"

namespace hepatica {

struct TissueContrast {
    FloatVolume excess;          // intensity minus the local parenchyma, in HU; 0 outside the liver
    double parenchyma_hu = 0.0;  // median over `interior`, lightly smoothed
    double noise_hu = 0.0;       // standard deviation of the parenchyma around its local level
    Mask interior;               // the liver without its outermost 3 mm, where fat mixes in
    // Excess above which a voxel counts as vessel, if the user has set it; otherwise it follows
    // from the noise.
    std::optional<double> threshold_hu;
};

// The local level is a Gaussian mean (sigma 8 mm) of the voxels that differ from it by less than
// two standard deviations, so that vessels and tumours do not count; found by iteration. Other
// statistics are robust: medians, not means. Both images on one grid. Throws InputError where the
// liver or its interior is empty; Cancelled.
TissueContrast measure_tissue(const FloatVolume& intensity, const Mask& liver, Job& job);

// Median and standard deviation of the noise over the object voxels of a mask. The deviation is
// estimated from the lower half alone (1.4826 times the median distance below the median), because
// vessels only add to the upper half. Both are 0 for an empty mask.
struct RobustSpread {
    double median = 0.0;
    double deviation = 0.0;
};
RobustSpread robust_spread(const FloatVolume& values, const Mask& where, const Job& job = Job());

}  // namespace hepatica
