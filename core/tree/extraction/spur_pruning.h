// SPDX-License-Identifier: GPL-3.0-or-later
// Removes the spurs that thinning leaves in a skeleton where the vessel's wall is bumpy.
#pragma once

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Removes end links that reach less than spur_radii radii, or less than `shortest_mm`, beyond the
// wall of the vessel they leave, the worst at each node first, until none is left; also rings that
// fit into their vessel's lumen. Then joins links at passing nodes.
void prune_spurs(VesselGraph& graph, double spur_radii, double shortest_mm);

}  // namespace hepatica
