// SPDX-License-Identifier: GPL-3.0-or-later
// The first half of the segmentation: the liver on its working grid, its contrast, and every voxel
// that looks like one of its vessels.
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
    Mask liver;  // closed; given or found; on the frame's grid
    bool liver_was_given = false;
};

struct DetectedVessels : MeasuredLiver {
    Detection detection;
};

// Finds the liver where none is given, resamples it and measures its contrast. Begins three stages,
// two where a liver is given. Throws InputError where no liver is found, or where the window holds
// the intensity of the liver's own tissue; Cancelled.
MeasuredLiver measure_liver(const Volume& ct, const SegmentationOptions& options, Job& job);

// Removes connected pieces that lie mostly in the rim of the searched region or, where the liver
// was found, mostly outside it: they are vessels and walls of other organs. On the liver's grid.
// Throws Cancelled.
Mask without_others(const MeasuredLiver& measured, const Mask& vessels, const Job& job);

// measure_liver(), then the stage "Segmenting the vessels". The shares: see DetectionOptions.
DetectedVessels detect_in_liver(const Volume& ct, const SegmentationOptions& options,
                                double line_share, const std::optional<double>& doubtful_share,
                                Job& job);

// The contrast of the detected vessels, measured away from the liver's border.
ContrastStatistics contrast_of(const DetectedVessels& found, Job& job);

// Throws InputError, with the measured values, where the detected vessels are too few or too faint
// to be those of a liver.
void require_contrast(const ContrastStatistics& measured, const DetectedVessels& found,
                      const std::optional<std::pair<double, double>>& window_hu);

}  // namespace hepatica
