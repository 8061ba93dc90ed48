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
    ContrastStatistics statistics;
};

// Begins the stages from "Finding the liver" to "Segmenting the vessels". line_share: of
// DetectionOptions. Throws as segment_vessels does.
DetectedVessels detect_in_liver(const Volume& ct, const SegmentationOptions& options,
                                double line_share, Job& job);

}  // namespace hepatica
