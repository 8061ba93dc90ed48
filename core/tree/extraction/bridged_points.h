// SPDX-License-Identifier: GPL-3.0-or-later
// Remembers which centreline points bridge a gap. Graphs are split, joined and turned on the way to
// a tree, but their points never move, so that bridged points are known by position.
#pragma once

#include <set>
#include <tuple>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Not thread-safe.
class BridgedPoints {
  public:
    // Adds a bridge's points without the first and last, which lie on the vessels that it joins.
    void add(const std::vector<Vec3>& path_mm);
    // Adds the points that a tree has marked.
    void add(const VesselTree& tree);
    // Marks the added points in a tree.
    void mark(VesselTree& tree) const;

  private:
    using Place = std::tuple<double, double, double>;
    static Place place_of(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

    std::set<Place> places_;
};

}  // namespace hepatica
