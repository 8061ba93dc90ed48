// SPDX-License-Identifier: GPL-3.0-or-later
// Where the portal trunk begins and where it divides: a skeleton ends somewhere in a wide lumen, or
// goes on into pancreas and bowel, not at the section at which the trunk comes in.
#pragma once

#include <optional>
#include <vector>

#include "core/tree/extraction/component_pruning.h"
#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

// Leads the portal centreline nearest to `entry_mm` there, as wide as it is where it leaves off, so
// that an end lies there. A wide end of the portal vein within 15 mm beyond the place where it
// leaves off goes. Nothing changes where no portal vein lies within 15 mm, or where one is there
// already.
void lead_trunk_to(const Vec3& entry_mm, VesselGraph& graph);

// The segment at whose end the portal trunk divides: down from the root of the longest portal tree
// to the first node beyond which a second branch holds at least a seventh of its length. There must
// be a portal segment.
int end_of_portal_trunk(const VesselTree& tree);

struct ShortTrunk {
    VesselGraph graph;
    Vec3 begins_mm = Vec3::Zero();
    RemovedPieces beside;  // what hung on the trunk before; the trunk itself does not count
    std::vector<VesselSeed> left_out;  // points of all that is gone
};

// The portal vein divides outside of the liver, and what joins its trunk before comes from other
// organs. Where the longest portal tree begins within 15 mm of `entry_mm`, at which the trunk was
// seen to come in from outside, it begins one radius of the trunk before it divides, and what hung
// on the trunk before that is gone. None where nothing would go, where the trunk never divides, or
// where a seed lies in what would go.
std::optional<ShortTrunk> short_trunk(const VesselTree& tree, const Vec3& entry_mm,
                                      const std::vector<VesselSeed>& seeds);

}  // namespace hepatica
