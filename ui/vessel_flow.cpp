// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/vessel_flow.h"

#include <utility>

namespace hepatica {
namespace {

constexpr int samples = 160;

}  // namespace

InjectionCurves injection_curves(const VesselTree& tree, const InjectionOptions& injection,
                                 double until_s, Job& job) {
    InjectionOptions sampled = injection;
    sampled.until_s = until_s;
    sampled.step_s = until_s / samples;
    const InjectionResult run = inject(tree, sampled, job);

    Curve pressure{"at the tip", {}, {}};
    Curve delivered{"past the ends", {}, {}};
    for (const InjectionSample& sample : run.series) {
        pressure.x.push_back(sample.time_s);
        pressure.y.push_back(sample.inlet_pressure_pa);
        const double share = sample.injected_g > 0.0 ? sample.delivered_g / sample.injected_g : 0.0;
        delivered.x.push_back(sample.time_s);
        delivered.y.push_back(100.0 * share);
    }
    return {{"Pressure at the catheter",
             "Time (s)",
             "Pressure at the catheter (Pa)",
             {std::move(pressure)}},
            {"Delivery", "Time (s)", "Drug that has passed the ends (%)", {std::move(delivered)}}};
}

}  // namespace hepatica
