// SPDX-License-Identifier: GPL-3.0-or-later
// What the window shows of an injection beside the picture: its curves over time. No toolkit.
#pragma once

#include "core/base/job.h"
#include "core/flow/injection.h"
#include "core/tree/vessel_tree.h"
#include "render/chart.h"

namespace hepatica {

struct InjectionCurves {
    Chart pressure;  // total pressure at the catheter's tip over time
    Chart delivery;  // share of the injected drug that has passed the ends
};

// Runs the very injection that a frame shows (its DrugView's `injection`) on the tree at rest, from
// 0 to `until_s` > 0 (its `end_s`). Throws InputError for an injection that makes no sense,
// Cancelled.
InjectionCurves injection_curves(const VesselTree& tree, const InjectionOptions& injection,
                                 double until_s, Job& job);

}  // namespace hepatica
