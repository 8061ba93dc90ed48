// SPDX-License-Identifier: GPL-3.0-or-later
// A case's vessels as another threshold or a smoother surface would have them, fast enough to
// follow a slider: the strength of all lines in the liver is measured once, and only which of them
// are believed changes.
#pragma once

#include <cstdint>

#include "core/base/job.h"
#include "core/reconstruction/detected_vessels.h"

namespace hepatica {

struct ThresholdChoice {
    // Of the strength from which on a line is believed, least_line_share to most_line_share: below
    // 1 more and fainter vessels, and more of what is none; above 1 fewer and surer ones.
    double line_share = 1.0;
    int refinement_recursions = 0;  // Gaussian smoothing of the surface (paper, II.A.2), 0 to 10
};

// Keeps about a dozen bytes a voxel of the liver's box at 0.65 mm, some 200 MB. After construction
// it does not change: any thread may ask it.
class VesselPreview {
  public:
    // `organs`: organ_label, on any grid in the frame of `ct`; where it holds no liver, the liver
    // is found. Begins up to preview_stages stages. Throws InputError where there is no liver;
    // Cancelled.
    VesselPreview(const Volume& ct, const Mask& organs, Job& job);

    // `present`: not 0 where the case has vessels now, on any grid in the frame of the CT. Returns
    // them with what this choice brings as `gained`, and without what it drops: the same voxels
    // where the choice is the usual one. Walls of what is gained are not fitted. Takes about half a
    // second. Throws InputError where the choice is out of its range; Cancelled.
    Mask vessels(const Mask& present, const ThresholdChoice& choice, std::uint8_t gained,
                 Job& job) const;

  private:
    Mask believed(double line_share, Job& job) const;
    Mask with_threshold(const Mask& present, double line_share, std::uint8_t gained,
                        Job& job) const;

    MeasuredLiver liver_;
    MeasuredLines lines_;
    Mask usual_;  // what is believed at a share of 1
};
inline constexpr int preview_stages = 4;

}  // namespace hepatica
