// SPDX-License-Identifier: GPL-3.0-or-later
// Assigns each link its vascular system (portal vein, hepatic veins, artery) from a mask of system
// numbers. Unknown links join the system they are connected to; where two systems meet they are
// separated at the narrowest link between them, as in a watershed along the tree.
#pragma once

#include "core/image/volume.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Gives each link the system in whose voxels most of its points lie, with that share of its points
// as confidence; a link with a long stretch in another system is split. Links in voxels of an
// unknown system, or in none, take the system they are connected to, widest links first, with
// confidence 0. Components without a known system stay unknown.
void assign_systems(VesselGraph& graph, const Mask& systems);

}  // namespace hepatica
