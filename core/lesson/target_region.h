// SPDX-License-Identifier: GPL-3.0-or-later
// A place on the tree and all that branches off beyond it, by the anatomy: what an injection is
// aimed at.
#pragma once

#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

class TargetRegion {
  public:
    // Throws InputError where the tree has no such segment.
    TargetRegion(const VesselTree& tree, const TreePoint& from);

    bool contains(const TreePoint& point) const;
    // The segment's distal node lies in it.
    bool contains_end_of(int segment) const;

  private:
    TreePoint from_;
    std::vector<char> beyond_;  // per segment: 1 where the whole of it lies beyond from_
};

}  // namespace hepatica
