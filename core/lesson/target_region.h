// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the vessel tree distal to a place, that is, the target of an injection.
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

}  // namespace hepatica
