// SPDX-License-Identifier: GPL-3.0-or-later
// A case's vessels as another threshold or a smoother surface would have them, fast enough to
// follow a slider: the strength of all lines in the liver is measured once, and only which of them
// are believed changes. What is usual is so for the default search in this liver; what the case
// has by another method, a window, a model or by hand is kept, and changed by the difference.
#pragma once

#include <cstdint>

#include "core/base/job.h"
#include "core/reconstruction/detected_vessels.h"

namespace hepatica {

// Below it vessels drown in noise, above it little more than the trunks is left.
inline constexpr double least_line_share = 0.75;
inline constexpr double most_line_share = 1.35;
inline constexpr int most_recursions = 10;

struct ThresholdChoice {
    // Of the strength from which on a line is believed, least_line_share to most_line_share: below
    // 1 more and fainter vessels, and more of what is none; above 1 fewer and surer ones.
    double line_share = 1.0;
    int refinement_recursions = 0;  // of the Gaussian smoothing (paper, II.A.2), to most_recursions

    bool operator==(const ThresholdChoice&) const = default;
};

// Keeps a dozen bytes a voxel of the liver's box at 0.65 mm, some 300 to 400 MB. After construction
// it does not change: any thread may ask it.
class VesselPreview {
  public:
    // `organs`: organ_label, on any grid in the frame of `ct`; where it holds no liver, the liver
    // is found. Begins up to preview_stages stages. Throws InputError where there is no liver;
    // Cancelled.
    VesselPreview(const Volume& ct, const Mask& organs, Job& job);

    // `present`: not 0 where the case has vessels now, on any grid in the frame of the CT. Returns
    // them with what this choice brings as `gained`, and without what it drops: the same voxels
    // where the choice is the usual one. What comes in reaches beyond the walls that are there; its
    // own walls are not fitted. Takes a second or two. Throws InputError where the choice is out of
    // its range; Cancelled.
    Mask vessels(const Mask& present, const ThresholdChoice& choice, std::uint8_t gained,
                 Job& job) const;

  private:
    Mask believed(double line_share, Job& job) const;
    Mask gained_at(double line_share, const Mask& present, Job& job) const;
    Mask lost_at(double line_share, Job& job) const;

    MeasuredLiver liver_;
    MeasuredLines lines_;
    Mask usual_;  // what is believed at a share of 1
};
inline constexpr int preview_stages = 4;

}  // namespace hepatica
