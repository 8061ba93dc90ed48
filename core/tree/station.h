// SPDX-License-Identifier: GPL-3.0-or-later
// Position and radius at an arc length along a segment, linear between the centreline's points.
#pragma once

#include "core/tree/vessel_tree.h"

namespace hepatica {

struct Station {
    Vec3 position_mm = Vec3::Zero();
    double radius_mm = 0.0;
};

// The point of a segment's centreline nearest to a position.
struct NearestStation {
    double arclength_mm = 0.0;
    double distance_mm = 0.0;
};
// The segment has two points or more, no consecutive ones equal. The first of equally near points.
NearestStation nearest_station(const VesselSegment& segment, const Vec3& position_mm);

// The segment has one point or more. An arc length outside the segment gives its nearest end.
Station station_at(const VesselSegment& segment, double arclength_mm);

}  // namespace hepatica
