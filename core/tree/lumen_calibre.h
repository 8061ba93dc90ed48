// SPDX-License-Identifier: GPL-3.0-or-later
// How wide a vessel is at a place, and how much narrower than its neighbourhood lets one expect:
// the interpolated reference of quantitative angiography, a straight line through the diameters
// before and behind the place, so that a vessel that tapers evenly has no stenosis.
#pragma once

#include <optional>

#include "core/tree/vessel_tree.h"

namespace hepatica {

struct LumenCalibre {
    int segment = -1;
    double arclength_mm = 0.0;
    Vec3 position_mm = Vec3::Zero();  // on the centreline
    double diameter_mm = 0.0;
    // Expected there, and by what share of it the lumen is narrower (below 0: wider). Nothing where
    // the segment ends too near to tell.
    std::optional<double> reference_mm;
    std::optional<double> stenosis;
};

// Of the vessel whose lumen holds the place, of several the one whose axis is nearest in radii; or
// else of that whose wall is nearest, at most `margin_mm` away; nothing where there is none. The
// reference is fitted to the diameters from `near_mm` to `far_mm` along the same segment on either
// side, of which half must be there at least.
std::optional<LumenCalibre> calibre_at(const VesselTree& tree, const Vec3& position_mm,
                                       double margin_mm = 2.0, double near_mm = 5.0,
                                       double far_mm = 15.0);

}  // namespace hepatica
