// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/target_region.h"

#include <string>

#include "core/base/error.h"
#include "core/tree/station.h"

namespace hepatica {

// Parents precede their children, so one pass suffices.
TargetRegion::TargetRegion(const VesselTree& tree, const TreePoint& from)
    : from_(from), beyond_(tree.segments.size(), 0) {
    if (from.segment < 0 || from.segment >= static_cast<int>(tree.segments.size()))
        throw InputError("there is no segment " + std::to_string(from.segment), "the target",
                         "Choose a place on the vessel tree");
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const int parent = tree.segments[s].parent;
        beyond_[s] = parent >= 0 && (parent == from.segment || beyond_[parent] != 0);
    }
}

bool TargetRegion::contains(const TreePoint& point) const {
    if (point.segment == from_.segment) return point.arclength_mm >= from_.arclength_mm;
    return contains_end_of(point.segment);
}

bool TargetRegion::contains_end_of(int segment) const {
    return segment >= 0 && (segment == from_.segment || beyond_[segment] != 0);
}

Vec3 place_that_feeds(const VesselTree& tree, const Vec3& at_mm) {
    VesselTree feeding;  // nearest_point() looks at segments alone
    for (const VesselSegment& segment : tree.segments)
        if (segment.system == VascularSystem::portal || segment.system == VascularSystem::artery)
            feeding.segments.push_back(segment);
    const VesselTree& searched = feeding.segments.empty() ? tree : feeding;
    const TreePoint nearest = nearest_point(searched, at_mm);
    return station_at(searched.segments[static_cast<std::size_t>(nearest.segment)],
                      nearest.arclength_mm)
        .position_mm;
}

}  // namespace hepatica
