// SPDX-License-Identifier: GPL-3.0-or-later
// Places bifurcations. Thinning puts a bifurcation into the crotch, up to a radius downstream of
// the point at which the axes of the branches meet; here it is moved to that point, which has the
// least sum of squared distances to the axes.
#pragma once

#include <vector>

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Moves every node with three or more links to the point nearest to the axes of its links, and
// draws each link straight from there to where it leaves the node's lumen.
//   reliable[i][k]: whether point k of link i lies in the middle of a lumen of its own
//   voxel_mm: size of a voxel; a node moves by at most its radius and two voxels
void place_forks(VesselGraph& graph, const std::vector<std::vector<std::uint8_t>>& reliable,
                 double voxel_mm);

}  // namespace hepatica
