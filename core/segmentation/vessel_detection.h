// SPDX-License-Identifier: GPL-3.0-or-later
// The three ways from contrast to vessel voxels; vessel_segmentation.h says which is for what.
#pragma once

#include <optional>
#include <utility>

#include "core/base/job.h"
#include "core/segmentation/liver_frame.h"
#include "core/segmentation/segmentation_method.h"
#include "core/segmentation/tissue_contrast.h"

namespace hepatica {

// Less is dropped as a crumb.
inline constexpr double smallest_vessel_mm3 = 200.0;

// What coherent lines were told from noise by.
struct LineEvidence {
    FloatVolume rise;            // smoothed excess over the tissue, in HU
    double deviation_hu = 0.0;   // of the noise in it, > 0
    double false_line_hu = 0.0;  // the strength of a line that noise can make, > 0
};

// What `coherent` without a window measures of a liver, before it believes any line.
struct MeasuredLines {
    FloatVolume strength;       // of the line through each voxel, in HU; 0 where none may be
    LineEvidence evidence;      // same grid
    Mask liver;                 // in which lines are looked for; same grid
    double strong_share = 0.0;  // of a false line's strength: a line that is believed,
    double weak_share = 0.0;    // and the rise of a voxel that hangs on to one
};

struct DetectionOptions {
    SegmentationMethod method = SegmentationMethod::coherent;
    // Of the strength from which on `coherent` believes a line; 1 is right where nothing else
    // chooses among the lines, less finds more of the vessels and more of what is none.
    double line_share = 1.0;
};

struct Detection {
    Mask vessels;                               // 0 or 1
    Mask centreline;                            // multi_layer only, else empty
    std::optional<LineEvidence> evidence = {};  // of `coherent` without a window of the user's
};

// Thresholds are multiples of the noise that is left after smoothing, measured in this liver; for
// `coherent` they follow from the strength of lines darker than their surroundings, which no
// vessel is. ct_spacing_mm is that of the CT itself, all > 0: coarse voxels dim and blur what is
// thin. Throws Cancelled.
Detection detect_vessels(const TissueContrast& tissue, const Mask& liver, const Vec3& ct_spacing_mm,
                         const DetectionOptions& options, Job& job);

// The lines that may be believed at line_share (> 0) or more, for believed_lines().
// tissue.threshold_hu must be empty. Throws Cancelled.
MeasuredLines measure_lines(const TissueContrast& tissue, const Mask& liver,
                            const Vec3& ct_spacing_mm, double line_share, Job& job);

// The voxels that detect_vessels() finds at this share, before their walls are fitted; line_share
// is at least that which was measured. Throws Cancelled.
Mask believed_lines(const MeasuredLines& lines, double line_share, Job& job);

// Uses the window that the user has set: vessels have intensities between low and high. The excess
// is then measured from one level for the whole liver. Throws InputError unless low < high.
void apply_window(const LiverFrame& frame, const std::pair<double, double>& window_hu,
                  TissueContrast& tissue);

}  // namespace hepatica
