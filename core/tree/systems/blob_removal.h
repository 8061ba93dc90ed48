// SPDX-License-Identifier: GPL-3.0-or-later
// Vessels taper. What hangs on a vessel by a neck and is wide and short beyond it is a piece of
// bowel, heart, kidney or tumour that shines into the segmentation.
#pragma once

#include "core/tree/extraction/component_pruning.h"

namespace hepatica {

// Removes from a tree what hangs on the neck of a segment and is, beyond the neck, at least
// 4 mm in radius, 1.5 times as wide as the neck, and within a box whose diagonal is shorter than
// ten of its radii; and trees beside the longest one of their system that are at least 4 mm in
// radius and fit into a box whose diagonal is shorter than six of their radii: pieces of the vena
// cava below the liver. What a seed lies in (within its lumen, or 3 mm) stays. `graph` is left as
// it is where nothing is found; else its nodes are numbered anew.
RemovedPieces remove_blobs(const VesselTree& tree, const std::vector<VesselSeed>& seeds,
                           VesselGraph& graph);

}  // namespace hepatica
