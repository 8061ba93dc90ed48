// SPDX-License-Identifier: GPL-3.0-or-later
// Projects positions onto the edges of a segment, and interpolates along them.
#include "core/tree/station.h"

#include <algorithm>
#include <limits>

namespace hepatica {

NearestStation nearest_station(const VesselSegment& segment, const Vec3& position_mm) {
    const std::vector<Vec3>& points = segment.points_mm;
    NearestStation best{0.0, std::numeric_limits<double>::infinity()};
    double start_mm = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 edge = points[i] - points[i - 1];
        const double share =
            std::clamp((position_mm - points[i - 1]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        const double distance_mm = (points[i - 1] + share * edge - position_mm).norm();
        if (distance_mm < best.distance_mm) best = {start_mm + share * edge.norm(), distance_mm};
        start_mm += edge.norm();
    }
    return best;
}

Station station_at(const VesselSegment& segment, double arclength_mm) {
    const auto& points = segment.points_mm;
    const auto& radii = segment.radii_mm;
    if (!(arclength_mm > 0.0)) return {points.front(), radii.front()};
    double left = arclength_mm;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 step = points[i] - points[i - 1];
        const double length = step.norm();
        if (left < length) {
            const double share = left / length;
            return {points[i - 1] + share * step, radii[i - 1] + share * (radii[i] - radii[i - 1])};
        }
        left -= length;
    }
    return {points.back(), radii.back()};
}

}  // namespace hepatica
