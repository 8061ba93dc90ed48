// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the vessel tree distal to a place, that is, the target of an injection, and the place
// from where a tumour is reached.
#pragma once

#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

class TargetRegion {
  public:
    // Throws InputError if the tree has no such segment.
    TargetRegion(const VesselTree& tree, const TreePoint& from);

    bool contains(const TreePoint& point) const;
    // True if the segment's distal node lies in the region.
    bool contains_end_of(int segment) const;

  private:
    TreePoint from_;
    std::vector<char> beyond_;  // per segment: 1 if all of it lies beyond from_'s segment
};

// The place, mm, on the centreline that a target for what lies at `at_mm`, a tumour's middle,
// begins at: the nearest one of the portal and arterial vessels, which feed it; where there are
// none, of all. O(points). Throws InputError if the tree is empty.
Vec3 place_that_feeds(const VesselTree& tree, const Vec3& at_mm);

}  // namespace hepatica
