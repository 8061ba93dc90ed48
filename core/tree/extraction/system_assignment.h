// SPDX-License-Identifier: GPL-3.0-or-later
// Which vascular system (portal vein, hepatic veins, artery) each link belongs to, from a mask
// whose values are numbers of systems. What the mask leaves unknown joins the system that it hangs
// on; where two systems meet they are parted at the narrowest link between them: a watershed along
// the tree.
#pragma once

#include "core/image/volume.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Gives each link the system whose voxels most of its points lie in, and the share of its points
// that do as its confidence; a link of which a long stretch lies in another system is split. Links
// that lie in voxels of an unknown system, or in none, take the system of what they hang on, the
// widest first, with confidence 0; components without any known system stay unknown.
void assign_systems(VesselGraph& graph, const Mask& systems);

}  // namespace hepatica
