// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/station.h"

namespace hepatica {

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
