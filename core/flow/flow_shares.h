// SPDX-License-Identifier: GPL-3.0-or-later
// Each branch's share of the blood of its tree, at rest.
#pragma once

#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Share of each segment in the flow of its own root, at a portal vein's resting flow and one
// pressure at all ends. A system in several trees has several roots, and shares of two trees cannot
// be compared: nothing tells what each of them gets. Empty where the tree carries no flow that
// could be solved.
std::vector<double> flow_shares(const VesselTree& tree);

}  // namespace hepatica
