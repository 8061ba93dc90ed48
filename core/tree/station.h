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

// The place of a segment's centreline that is nearest to a position.
struct NearestStation {
    double arclength_mm = 0.0;
    double distance_mm = 0.0;
};
// Of a segment with two points or more; the first of several that are equally near.
NearestStation nearest_station(const VesselSegment& segment, const Vec3& position_mm);

// Of a segment with one point or more; before its begin or beyond its end that of the end there.
Station station_at(const VesselSegment& segment, double arclength_mm);

}  // namespace hepatica
