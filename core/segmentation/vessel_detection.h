// SPDX-License-Identifier: GPL-3.0-or-later
// The three ways from contrast to vessel voxels; vessel_segmentation.h says which is for what.
#pragma once

#include <utility>

#include "core/base/job.h"
#include "core/segmentation/liver_frame.h"
#include "core/segmentation/segmentation_method.h"
#include "core/segmentation/tissue_contrast.h"

namespace hepatica {

struct Detection {
    Mask vessels;     // 0 or 1
    Mask centreline;  // multi_layer only, else empty
};

// Thresholds are multiples of the noise that is left after smoothing, measured in this liver; for
// `coherent` they follow from the strength of lines darker than their surroundings, which no
// vessel is. ct_spacing_mm is that of the CT itself, all > 0: coarse voxels dim and blur what is
// thin. Throws Cancelled.
Detection detect_vessels(const TissueContrast& tissue, const Mask& liver, const Vec3& ct_spacing_mm,
                         SegmentationMethod method, Job& job);

// Uses the window that the user has set: vessels have intensities between low and high. The excess
// is then measured from one level for the whole liver. Throws InputError unless low < high.
void apply_window(const LiverFrame& frame, const std::pair<double, double>& window_hu,
                  TissueContrast& tissue);

}  // namespace hepatica
