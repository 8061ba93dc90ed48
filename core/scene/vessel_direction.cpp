// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/vessel_direction.h"

namespace hepatica {

Vec3 vessel_direction(const VesselTree& tree, const TreePoint& place) {
    if (place.segment < 0 || place.segment >= static_cast<int>(tree.segments.size()))
        return Vec3::Zero();
    const std::vector<Vec3>& points = tree.segments[place.segment].points_mm;
    double left_mm = place.arclength_mm;
    Vec3 along = Vec3::Zero();
    for (std::size_t i = 1; i < points.size() && left_mm >= 0.0; ++i) {
        const Vec3 stretch = points[i] - points[i - 1];
        left_mm -= stretch.norm();
        if (!stretch.isZero(0.0)) along = stretch.normalized();
    }
    return along;
}

}  // namespace hepatica
