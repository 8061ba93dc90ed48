// SPDX-License-Identifier: GPL-3.0-or-later
// The share of each branch in the blood flow of its tree, at rest.
#pragma once

#include <string>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Share of each segment in the flow of its own root, at a portal vein's resting flow and the same
// pressure at all ends. A system in several trees has several roots; shares of different trees
// cannot be compared, because their flows are unknown. Empty where no flow could be solved.
std::vector<double> flow_shares(const VesselTree& tree);

// One warning, in the order of the segments, for each end that takes more than half of the flow of
// a tree with at least four ends: the vessel may be cut off there, or it may be an inlet. `shares`
// as from flow_shares().
std::vector<std::string> warnings_of_ends(const VesselTree& tree,
                                          const std::vector<double>& shares);

}  // namespace hepatica
