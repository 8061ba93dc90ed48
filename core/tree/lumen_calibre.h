// SPDX-License-Identifier: GPL-3.0-or-later
// Diameter and degree of stenosis of a vessel at a place, against the interpolated reference
// diameter of quantitative angiography: a line fitted to the diameters before and behind the place,
// so that an evenly tapering vessel has no stenosis.
#pragma once

#include <optional>

#include "core/tree/vessel_tree.h"

namespace hepatica {

struct LumenCalibre {
    int segment = -1;
    double arclength_mm = 0.0;
    Vec3 position_mm = Vec3::Zero();  // on the centreline
    double diameter_mm = 0.0;
    // The reference diameter, and the share of it by which the lumen is narrower (negative: wider).
    // None where the vessel ends too near.
    std::optional<double> reference_mm;
    std::optional<double> stenosis;
};

// Measures the vessel whose lumen contains the position (of several, the one whose axis is nearest
// relative to its radius), else the one whose wall is nearest, at most `margin_mm` away; none where
// there is none. The reference is fitted by least squares to diameters sampled from `near_mm` to
// `far_mm` (near < far) along the same vessel on both sides: past a side branch where the median
// radius stays within a tenth. At least half of the samples must exist on each. O(points of the
// tree). Thread-safe.
std::optional<LumenCalibre> calibre_at(const VesselTree& tree, const Vec3& position_mm,
                                       double margin_mm = 2.0, double near_mm = 5.0,
                                       double far_mm = 15.0);

}  // namespace hepatica
