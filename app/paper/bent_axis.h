// SPDX-License-Identifier: GPL-3.0-or-later
// The deformed axis of a stretch of vessel: the red line of the paper's Fig. 3.
#pragma once

#include <span>
#include <vector>

#include "core/scene/frame.h"
#include "core/scene/vertex_places.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

class BentAxis {
  public:
    // The stretch lies along the longest path of the tree between two shares of its length (see
    // point_on_longest_path()). `places` must hold all vertices of the body.
    BentAxis(const VesselTree& tree, double from_share, double to_share,
             std::span<const VertexPlace> places);

    // The smoothed line through the mean positions of the vertices around each of its points. Empty
    // where no vertices are near.
    std::vector<Vec3> in(const Frame& frame) const;

  private:
    std::vector<std::vector<int>> around_;  // vertices around each point, at least one
};

}  // namespace hepatica
