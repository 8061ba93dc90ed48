// SPDX-License-Identifier: GPL-3.0-or-later
// Which centreline points bridge a gap. Graphs are split, joined and turned on the way to a tree,
// but never move a point: bridged points are known by their place.
#pragma once

#include <set>
#include <tuple>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Not thread-safe.
class BridgedPoints {
  public:
    // A bridge's points; the first and the last lie on the vessels that it joins.
    void add(const std::vector<Vec3>& path_mm);
    // Those that a tree has marked.
    void add(const VesselTree& tree);
    // Marks the points of a tree that were added.
    void mark(VesselTree& tree) const;

  private:
    using Place = std::tuple<double, double, double>;
    static Place place_of(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

    std::set<Place> places_;
};

}  // namespace hepatica
