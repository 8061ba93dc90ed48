// SPDX-License-Identifier: GPL-3.0-or-later
// The first half of the segmentation: the liver on its working grid, the contrast in it, and every
// voxel that looks like one of its vessels.
#pragma once

#include "core/base/job.h"
#include "core/reconstruction/vessel_segmentation.h"
#include "core/segmentation/liver_frame.h"
#include "core/segmentation/tissue_contrast.h"
#include "core/segmentation/vessel_detection.h"

namespace hepatica {

struct MeasuredLiver {
    LiverFrame frame;
    TissueContrast tissue;
    Mask liver;  // closed; where none was given, the one found; on the frame's grid
    bool liver_was_given = false;
};

struct DetectedVessels : MeasuredLiver {
    Detection detection;
};

// Begins the stages from "Finding the liver" to "Measuring the contrast". Throws InputError where
// there is no liver; Cancelled.
MeasuredLiver measure_liver(const Volume& ct, const SegmentationOptions& options, Job& job);

// Without the pieces that lie in the rim of what was searched, or outside of the liver that was
// found, for the most part: other organs' vessels and walls. On the liver's grid. Throws Cancelled.
Mask without_others(const MeasuredLiver& measured, const Mask& vessels, const Job& job);

// The same and the stage "Segmenting the vessels". line_share: of DetectionOptions.
DetectedVessels detect_in_liver(const Volume& ct, const SegmentationOptions& options,
                                double line_share, Job& job);

// The contrast of what was detected, measured away from the liver's border.
ContrastStatistics contrast_of(const DetectedVessels& found, Job& job);

// Throws InputError, naming what was measured, where what was detected is too little or too faint
// to be the liver's vessels.
void require_contrast(const ContrastStatistics& measured, const DetectedVessels& found,
                      const std::optional<std::pair<double, double>>& window_hu);

}  // namespace hepatica
