// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/vessel_flow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "core/flow/drug_front.h"

namespace hepatica {
namespace {

constexpr int samples = 160;

Fluid drug_of(const InjectDrug& injection) {
    Fluid fluid = mixture(blood(), second_phase(injection.second_phase), injection.void_fraction);
    if (injection.drug_viscosity_pa_s) fluid.viscosity_pa_s = *injection.drug_viscosity_pa_s;
    return fluid;
}

// When 95 % of the perfused volume has been reached, were the drug to flow like blood: a few
// nearly stagnant ends would otherwise stretch the axis out of use.
double filling_time_s(const FlowNetwork& network, const FlowConditions& conditions, int node) {
    FlowConditions alike = conditions;
    alike.resident = conditions.inlets.front().fluid;
    const ArrivalTimes times = arrival_times(network, solve_flow(network, alike), {node});
    std::vector<std::pair<double, double>> filled;  // when, and how much volume then
    double volume = 0.0;
    for (int s = 0; s < static_cast<int>(network.segments.size()); ++s) {
        const double last_s = times.last_s(s);
        if (!std::isfinite(last_s)) continue;
        filled.emplace_back(last_s, volume_mm3(network, s));
        volume += filled.back().second;
    }
    std::sort(filled.begin(), filled.end());
    double so_far = 0.0;
    for (const auto& [time_s, part] : filled) {
        so_far += part;
        if (so_far >= 0.95 * volume) return std::max(time_s, 1e-3);
    }
    return 1.0;
}

}  // namespace

InjectionCurves injection_curves(const VesselTree& tree, const TreePoint& tip,
                                 const InjectDrug& injection, Job& job) {
    job.begin_stage("injection");
    FlowNetwork network = network_of(tree);
    FlowConditions conditions;
    conditions.law = pressure_law(injection.pressure_model);
    conditions.resident = pure(blood());
    const int node = place_catheter(network, tip, false);
    conditions.inlets = {{node, InletKind::mass_flow, injection.mass_flow_g_s, drug_of(injection)}};
    const double longest_s = 1.5 * filling_time_s(network, conditions, node);
    DrugFront front(std::move(network), conditions, 0);

    InjectionCurves curves{
        {"Pressure at the catheter", "Time (s)", "Pressure at the catheter (Pa)", {}},
        {"Delivery", "Time (s)", "Drug that has passed the ends (%)", {}}};
    Curve pressure{"at the tip", {}, {}};
    Curve delivered{"past the ends", {}, {}};
    for (int i = 0; i <= samples; ++i) {
        job.advance(static_cast<double>(i) / samples);
        const double time_s = longest_s * i / samples;
        while (front.time_s() < time_s) {
            job.throw_if_cancelled();
            front.step(time_s - front.time_s());
        }
        const double injected_g = injection.mass_flow_g_s * time_s;
        const auto& left = front.outlet_mass_g();
        const double left_g = std::accumulate(left.begin(), left.end(), 0.0);
        pressure.x.push_back(time_s);
        pressure.y.push_back(front.flow().inlet_pressure_pa.front());
        delivered.x.push_back(time_s);
        delivered.y.push_back(injected_g > 0.0 ? 100.0 * left_g / injected_g : 0.0);
    }
    curves.pressure.curves = {std::move(pressure)};
    curves.delivery.curves = {std::move(delivered)};
    return curves;
}

}  // namespace hepatica
