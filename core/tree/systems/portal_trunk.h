// SPDX-License-Identifier: GPL-3.0-or-later
// Corrects the beginning of the portal trunk: a skeleton ends somewhere in a wide lumen or
// continues into pancreas and bowel, not at the section where the trunk enters.
#pragma once

#include <optional>
#include <vector>

#include "core/tree/extraction/component_pruning.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Extends the portal centreline nearest to `entry_mm` to that point, with the radius it has where
// it is left, so that an end lies there. A wide portal end of up to 15 mm at the point where it is
// left is removed. The graph stays as it is where no portal vein lies within 15 mm, or where one is
// within 1 mm.
void lead_trunk_to(const Vec3& entry_mm, VesselGraph& graph);

// The segment at whose end the portal trunk divides: from the root of the longest portal tree down
// to the first node where a second branch holds at least a seventh of the tree's length. The tree
// must have a portal segment that closes no loop. O(segments log segments).
int end_of_portal_trunk(const VesselTree& tree);

struct ShortTrunk {
    VesselGraph graph;
    Vec3 begins_mm = Vec3::Zero();
    RemovedPieces beside;  // removed branches of the trunk; the trunk itself does not count
    std::vector<VesselSeed> left_out;  // points of everything removed
};

// Shortens the portal trunk, because the portal vein divides outside the liver and what joins its
// trunk before that comes from other organs. Applies where the longest portal tree begins within 15
// mm of `entry_mm`, where the trunk was seen to enter. The tree then begins one radius of the trunk
// before its division, and branches before that are removed. None where nothing would be removed,
// where the trunk never divides, or where a seed lies in the removed part.
std::optional<ShortTrunk> short_trunk(const VesselTree& tree, const Vec3& entry_mm,
                                      const std::vector<VesselSeed>& seeds);

}  // namespace hepatica
