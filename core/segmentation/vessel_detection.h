// SPDX-License-Identifier: GPL-3.0-or-later
// The three methods from contrast to vessel voxels. vessel_segmentation.h (in core/reconstruction)
// says which one suits which purpose.
#pragma once

#include <optional>
#include <utility>

#include "core/base/job.h"
#include "core/segmentation/liver_frame.h"
#include "core/segmentation/segmentation_method.h"
#include "core/segmentation/tissue_contrast.h"

namespace hepatica {

// Smaller pieces are dropped.
inline constexpr double smallest_vessel_mm3 = 200.0;

// The measurements that separate coherent lines from noise.
struct LineEvidence {
    FloatVolume rise;            // smoothed excess over the tissue, in HU
    double deviation_hu = 0.0;   // standard deviation of its noise, > 0
    double false_line_hu = 0.0;  // strength above which hardly a line is noise, > 0
};

// Measurements of `coherent` without a window, before any line is accepted.
struct MeasuredLines {
    FloatVolume strength;   // of the line through each voxel, in HU; 0 where no line is possible
    LineEvidence evidence;  // same grid
    Mask liver;             // where lines are sought; same grid
    // Multiples of false_line_hu: the least strength of an accepted line, and the least rise of a
    // voxel that is joined to one.
    double strong_share = 0.0;
    double weak_share = 0.0;
};

struct DetectionOptions {
    SegmentationMethod method = SegmentationMethod::coherent;
    // Factor of the strength from which on `coherent` accepts a line. 1 suits where no later step
    // selects among the lines; a lower value finds more vessels and more false ones.
    double line_share = 1.0;
    // The same for lines that are looked at but not believed; at most line_share. None: there are
    // none.
    std::optional<double> doubtful_share = {};
};

struct Detection {
    Mask vessels;                               // 0 or 1
    Mask centreline;                            // multi_layer only, else empty
    std::optional<LineEvidence> evidence = {};  // of `coherent` without a window
    // What is detected at doubtful_share, with the vessels; empty where none is asked for, or the
    // method is another.
    Mask doubtful = {};
};

// Thresholds are multiples of the noise that is left after smoothing, measured in this liver; for
// `coherent` they follow from the strength of lines darker than their surroundings, which are not
// vessels. `liver` lies on the grid of `tissue`, of cubes. ct_spacing_mm is that of the CT itself,
// all > 0: coarse voxels dim and blur thin vessels. Throws Cancelled.
Detection detect_vessels(const TissueContrast& tissue, const Mask& liver, const Vec3& ct_spacing_mm,
                         const DetectionOptions& options, Job& job);

// The candidates for lines at line_share (> 0) or more, for believed_lines(). tissue.threshold_hu
// must be empty. Throws Cancelled.
MeasuredLines measure_lines(const TissueContrast& tissue, const Mask& liver,
                            const Vec3& ct_spacing_mm, double line_share, Job& job);

// The voxels that detect_vessels() finds at this share, before their walls are fitted. line_share
// must be at least the one given to measure_lines(). Throws Cancelled.
Mask believed_lines(const MeasuredLines& lines, double line_share, Job& job);

// Applies the user's window to `tissue`: vessels have intensities between low and high (HU). The
// excess is then measured from one level for the whole liver; above high it is 0, or the threshold
// where that is negative. Throws InputError unless low < high.
void apply_window(const LiverFrame& frame, const std::pair<double, double>& window_hu,
                  TissueContrast& tissue);

}  // namespace hepatica
