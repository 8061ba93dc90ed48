// SPDX-License-Identifier: GPL-3.0-or-later
// Each branch's share of the blood of its tree, at rest.
#pragma once

#include <string>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Share of each segment in the flow of its own root, at a portal vein's resting flow and one
// pressure at all ends. A system in several trees has several roots, and shares of two trees cannot
// be compared: nothing tells what each of them gets. Empty where the tree carries no flow that
// could be solved.
std::vector<double> flow_shares(const VesselTree& tree);

// What to make of ends that take more than half of the flow of their tree, where it has at least
// four: a vessel that is cut off there, or one by which blood comes in. One warning each, in the
// order of the segments. `shares` as flow_shares() has them.
std::vector<std::string> warnings_of_ends(const VesselTree& tree,
                                          const std::vector<double>& shares);

}  // namespace hepatica
