// SPDX-License-Identifier: GPL-3.0-or-later
// What the window shows of an injection beside the picture: its curves over time. No toolkit.
#pragma once

#include "core/base/job.h"
#include "core/session/command.h"
#include "core/tree/vessel_tree.h"
#include "render/chart.h"

namespace hepatica {

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
