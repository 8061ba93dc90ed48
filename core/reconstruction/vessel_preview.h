// SPDX-License-Identifier: GPL-3.0-or-later
// Preview of a case's vessels at another threshold or surface smoothing, fast enough to follow a
// slider: the strength of all lines in the liver is measured once, and only the threshold for
// accepting them changes. "Usual" is what the default search accepts in this liver. Vessels that
// the case has by another method, window, model or by hand are kept; only the difference to the
// usual is applied.
#pragma once

#include <cstdint>

#include "core/base/job.h"
#include "core/reconstruction/detected_vessels.h"

namespace hepatica {

// Range of the slider: below it noise hides the vessels, above it little but the trunks is left.
inline constexpr double least_line_share = 0.75;
inline constexpr double most_line_share = 1.35;
inline constexpr int most_recursions = 10;

struct ThresholdChoice {
    // The threshold on line strength relative to the usual one, least_line_share to
    // most_line_share: below 1 more and fainter vessels and more false ones, above 1 fewer and
    // surer ones.
    double line_share = 1.0;
    int refinement_recursions = 0;  // of the Gaussian smoothing (paper, II.A.2), 0 to
                                    // most_recursions

    bool operator==(const ThresholdChoice&) const = default;
};

// Keeps about a dozen bytes per voxel of the liver's box at 0.65 mm, 300 to 400 MB. Immutable after
// construction, so thread-safe.
class VesselPreview {
  public:
    // `organs`: organ_label, on any grid in the frame of `ct`; without a liver in it the liver is
    // found. Begins up to preview_stages stages. Throws InputError where there is no liver;
    // Cancelled.
    VesselPreview(const Volume& ct, const Mask& organs, Job& job);

    // Returns `present` (not 0 where the case has vessels now, on any grid in the frame of the CT)
    // with the vessels that this choice adds, labelled `gained`, and without those that it drops;
    // unchanged for the usual choice. Of a piece that loses voxels no crumb below 20 mm^3 stays.
    // Added vessels extend beyond the present walls; their own walls are not fitted. Takes a second
    // or two. Throws InputError where the choice is out of range; Cancelled.
    Mask vessels(const Mask& present, const ThresholdChoice& choice, std::uint8_t gained,
                 Job& job) const;

  private:
    Mask believed(double line_share, Job& job) const;
    Mask gained_at(double line_share, const Mask& present, Job& job) const;
    Mask lost_at(double line_share, Job& job) const;

    MeasuredLiver liver_;
    MeasuredLines lines_;
    Mask usual_;  // accepted lines at a share of 1
};
inline constexpr int preview_stages = 4;

}  // namespace hepatica
