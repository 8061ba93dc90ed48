// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/target_region.h"

#include <string>

#include "core/base/error.h"

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

}  // namespace hepatica
