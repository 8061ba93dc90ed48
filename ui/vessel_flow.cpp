// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/vessel_flow.h"

#include <utility>

#include "ui/words.h"

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

    Curve pressure{Words::id("at the tip"), {}, {}};
    Curve delivered{Words::id("past the ends"), {}, {}};
    for (const InjectionSample& sample : run.series) {
        pressure.x.push_back(sample.time_s);
        pressure.y.push_back(sample.inlet_pressure_pa);
        const double share = sample.injected_g > 0.0 ? sample.delivered_g / sample.injected_g : 0.0;
        delivered.x.push_back(sample.time_s);
        delivered.y.push_back(100.0 * share);
    }
    return {{Words::id("Pressure at the catheter"),
             Words::id("Time (s)"),
             Words::id("Pressure at the catheter (Pa)"),
             {std::move(pressure)}},
            {Words::id("Delivery"),
             Words::id("Time (s)"),
             Words::id("Drug that has passed the ends (%)"),
             {std::move(delivered)}}};
}

}  // namespace hepatica
