// SPDX-License-Identifier: GPL-3.0-or-later
// The axis of a stretch of vessel as the body carries it along: the red line of the paper's Fig. 3.
#pragma once

#include <span>
#include <vector>

#include "core/scene/frame.h"
#include "core/scene/vertex_places.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

class BentAxis {
  public:
    // Along the longest path of the tree between two shares of it (see point_on_longest_path).
    // `places` are those of the whole body's vertices.
    BentAxis(const VesselTree& tree, double from_share, double to_share,
             std::span<const VertexPlace> places);

    // Its points lie amidst the vertices around them; the line is smoothed. Empty where the vessel
    // is too thin for any.
    std::vector<Vec3> in(const Frame& frame) const;

  private:
    std::vector<std::vector<int>> around_;  // vertices of each point, at least one
};

}  // namespace hepatica
