// SPDX-License-Identifier: GPL-3.0-or-later
// Each branch's share of the blood of its system, at rest.
#pragma once

#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

// Share of each segment in the flow of its system's root, at a portal vein's resting flow and one
// pressure at all ends. Empty where the tree carries no flow that could be solved.
std::vector<double> flow_shares(const VesselTree& tree);

}  // namespace hepatica
