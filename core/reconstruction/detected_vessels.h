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

struct DetectedVessels {
    LiverFrame frame;
    TissueContrast tissue;
    Mask liver;  // closed; where none was given, the one found; on the frame's grid
    Detection detection;
};

// Begins the stages from "Finding the liver" to "Segmenting the vessels". line_share: of
// DetectionOptions. Throws InputError where there is no liver; Cancelled.
DetectedVessels detect_in_liver(const Volume& ct, const SegmentationOptions& options,
                                double line_share, Job& job);

// The contrast of what was detected, measured away from the liver's border.
ContrastStatistics contrast_of(const DetectedVessels& found, Job& job);

// Throws InputError, naming what was measured, where what was detected is too little or too faint
// to be the liver's vessels.
void require_contrast(const ContrastStatistics& measured, const DetectedVessels& found,
                      const std::optional<std::pair<double, double>>& window_hu);

}  // namespace hepatica
