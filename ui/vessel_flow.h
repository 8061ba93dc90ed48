// SPDX-License-Identifier: GPL-3.0-or-later
// What the window shows of the flow beside the picture: each branch's share of it, and an injection
// as curves over time. No toolkit.
#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/session/command.h"
#include "core/tree/vessel_tree.h"
#include "render/chart.h"

namespace hepatica {

// Share of each segment in the flow of its system's root, at a portal vein's resting flow and one
// pressure at all ends. Empty where the tree carries no flow that could be solved.
std::vector<double> flow_shares(const VesselTree& tree);

struct InjectionCurves {
    Chart pressure;  // total pressure at the catheter's tip over time
    Chart delivery;  // share of the injected drug that has passed the ends
};

// Runs the drug's front from the tip (on the tree at rest) for half as long again as the drug takes
// to reach most of the vessels; drug and blood keep their own densities and viscosities. Throws
// InputError for an injection that makes no sense, Cancelled.
InjectionCurves injection_curves(const VesselTree& tree, const TreePoint& tip,
                                 const InjectDrug& injection, Job& job);

}  // namespace hepatica
