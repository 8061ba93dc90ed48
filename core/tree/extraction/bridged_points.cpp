// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the exact coordinates of bridged points in a set.
#include "core/tree/extraction/bridged_points.h"

namespace hepatica {

void BridgedPoints::add(const std::vector<Vec3>& path_mm) {
    for (std::size_t i = 1; i + 1 < path_mm.size(); ++i) places_.insert(place_of(path_mm[i]));
}

void BridgedPoints::add(const VesselTree& tree) {
    for (const VesselSegment& segment : tree.segments)
        for (std::size_t i = 0; i < segment.bridged.size(); ++i)
            if (segment.bridged[i] != 0) places_.insert(place_of(segment.points_mm[i]));
}

void BridgedPoints::mark(VesselTree& tree) const {
    if (places_.empty()) return;
    for (VesselSegment& segment : tree.segments) {
        std::vector<std::uint8_t> bridged(segment.points_mm.size(), 0);
        bool any = false;
        for (std::size_t i = 0; i < bridged.size(); ++i) {
            bridged[i] = places_.contains(place_of(segment.points_mm[i])) ? 1 : 0;
            any = any || bridged[i] != 0;
        }
        if (any) segment.bridged = std::move(bridged);
    }
}

}  // namespace hepatica
