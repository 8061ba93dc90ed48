// SPDX-License-Identifier: GPL-3.0-or-later
// Where branches meet. Thinning puts a bifurcation into the crotch, up to a radius downstream of
// the point in which the axes of the branches meet; here it is moved to that point.
#pragma once

#include <vector>

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Moves every node in which three or more links meet to the point nearest to the axes of its links,
// and lays the links straight from there to where they leave the node's lumen.
//   reliable[i][k]: whether point k of link i lies in the middle of a lumen of its own
//   voxel_mm: size of a voxel; a node moves by no more than its radius and two voxels
void place_forks(VesselGraph& graph, const std::vector<std::vector<std::uint8_t>>& reliable,
                 double voxel_mm);

}  // namespace hepatica
