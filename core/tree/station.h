// SPDX-License-Identifier: GPL-3.0-or-later
// Place and radius of the lumen at a length along a segment, linear between the centreline's
// points.
#pragma once

#include "core/tree/vessel_tree.h"

namespace hepatica {

struct Station {
    Vec3 position_mm = Vec3::Zero();
    double radius_mm = 0.0;
};

// Of a segment with one point or more; before its begin or beyond its end that of the end there.
Station station_at(const VesselSegment& segment, double arclength_mm);

}  // namespace hepatica
