// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of an injection over time for the panel of charts. No widgets.
#pragma once

#include "core/base/job.h"
#include "core/flow/injection.h"
#include "core/tree/vessel_tree.h"
#include "render/chart.h"

namespace hepatica {

struct InjectionCurves {
    Chart pressure;  // total pressure at the catheter's tip over time
    Chart delivery;  // share of the injected drug that has passed the ends, in percent
};

// Computes the injection shown by a frame (DrugView::injection) on the tree at rest, from 0 to
// `until_s` > 0 (DrugView::end_s). Throws InputError for an invalid injection, and Cancelled.
InjectionCurves injection_curves(const VesselTree& tree, const InjectionOptions& injection,
                                 double until_s, Job& job);

}  // namespace hepatica
