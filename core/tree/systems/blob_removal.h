// SPDX-License-Identifier: GPL-3.0-or-later
// Removes blobs: vessels taper, so what is attached to a vessel by a neck and is wide and short
// beyond it is a piece of bowel, heart, kidney or tumour in the segmentation.
#pragma once

#include "core/tree/extraction/component_pruning.h"

namespace hepatica {

// Removes two kinds of blobs from a tree. The first is attached beyond the neck of a segment, with
// a radius of at least 4 mm and 1.5 times the neck's, in a box with a diagonal of less than ten of
// its radii. The second is a whole tree that is not the longest of its system, with a radius of at
// least 4 mm, in a box with a diagonal of less than six of its radii: pieces of the vena cava below
// the liver. A blob with a seed in it (within its lumen, or 3 mm) is kept. `graph` gets the
// remaining tree with new node ids; it is unchanged where nothing is removed.
RemovedPieces remove_blobs(const VesselTree& tree, const std::vector<VesselSeed>& seeds,
                           VesselGraph& graph);

}  // namespace hepatica
