// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/drug_arrival.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/base/median.h"
#include "core/flow/arrival_times.h"
#include "core/flow/flow_solution.h"

namespace hepatica {

namespace {

struct Arrivals {
    ArrivalTimes times;
    double mass_error_relative = 0.0;
};

// A drug like the blood that it displaces leaves the flow unchanged, and the times are exact.
Arrivals steady_arrivals(const VesselTree& tree, const InjectionOptions& options) {
    FlowNetwork network = network_of(tree, options.shape);
    FlowConditions conditions;
    tear_for(options, network, conditions);
    const int tip = place_catheter(network, *options.tip, options.wedged);
    conditions.law = options.law;
    conditions.resident = pure(options.liquid);
    conditions.inlets = {{tip, InletKind::mass_flow, options.mass_flow_g_s, conditions.resident}};
    const FlowSolution solution = solve_flow(network, conditions);
    return {arrival_times(network, solution, {tip}), solution.mass_error_relative};
}

// How long the catheter takes to inject the volume of all vessels.
double filling_s(const VesselTree& tree, const InjectionOptions& options) {
    return volume_mm3(network_of(tree, options.shape)) * options.liquid.density_g_mm3 /
           options.mass_flow_g_s;
}

// Any other drug changes the splits at bifurcations as it advances, and tears change them anyway.
Arrivals stepped_arrivals(const VesselTree& tree, const InjectionOptions& options, Job& job) {
    InjectionOptions run = options;
    // The curves over time are not needed, and take longer than a front that does not change flows.
    if (flows_like_blood(options)) run.step_s = std::clamp(filling_s(tree, options), 1e-9, 1e9);
    const InjectionResult result = inject(tree, run, job);
    return {result.arrival,
            std::max({result.begin.mass_error_relative, result.end.mass_error_relative,
                      result.balance.error_relative()})};
}

// When the drug's clock ends: five times the median arrival time of the vertices that are reached
// after the injection has begun; at the tip itself there may be many more. Segments with almost no
// flow would otherwise stretch clock and colours over days.
double useful_end_s(const std::vector<float>& arrival_s) {
    std::vector<float> reached;
    for (const float time_s : arrival_s)
        if (time_s > 0.0f && std::isfinite(time_s)) reached.push_back(time_s);
    if (reached.empty()) return std::numeric_limits<double>::infinity();
    return 5.0 * static_cast<double>(median(std::move(reached)));
}

// A tip within a radius of the place where a system is supplied means that place; otherwise only a
// stump would remain behind it.
TreePoint at_supply_where_near(TreePoint tip, const VesselTree& tree) {
    const VesselSegment& segment = tree.segments[tip.segment];
    const bool begins_system = segment.parent < 0 && !segment.closes_loop;
    if (begins_system && tip.arclength_mm < segment.radii_mm.front()) tip.arclength_mm = 0.0;
    return tip;
}

// When the drug comes to a tear from either side.
double at_stumps_s(const VesselTree& tree, const ArrivalTimes& times, const TreePoint& tear) {
    constexpr double far_mm = 1e9;  // clamped to the segment
    const int parent = tree.segments[tear.segment].parent;
    TreePoint before{tear.segment, tear.arclength_mm * (1.0 - 1e-9), 0.0};
    if (tear.arclength_mm <= 0.0 && parent >= 0) before = {parent, far_mm, 0.0};
    double first_s = std::min(times.arrival_s(before), times.arrival_s(tear));
    // At the end of a trunk all its branches have come off: the other side is theirs.
    if (tear.arclength_mm >= length_mm(tree.segments[tear.segment]))
        for (std::size_t s = 0; s < tree.segments.size(); ++s)
            if (tree.segments[s].parent == tear.segment)
                first_s =
                    std::min(first_s, times.arrival_s(TreePoint{static_cast<int>(s), 0.0, 0.0}));
    return first_s;
}

LaterTears tears_for_flow(const TornSince& torn) {
    LaterTears tears{.from_s = torn.from_s};
    for (const ThroughTear& tear : torn.tears) {
        tears.tears.push_back(tear.at);
        tears.areas_mm2.push_back(tear.area_mm2);
        tears.sides.push_back(tear.side ? 1 : 0);
    }
    return tears;
}

}  // namespace

InjectionOptions injection_options(const Injection& injection, const VesselTree& tree) {
    validate_drug_flow(injection.mass_flow_g_s);
    InjectionOptions options;
    options.tip = at_supply_where_near(injection.at, tree);
    options.wedged = false;
    options.mass_flow_g_s = injection.mass_flow_g_s;
    options.law = pressure_law(injection.pressure_model);
    options.second_phase = second_phase(injection.second_phase);
    options.void_fraction = injection.void_fraction;
    if (injection.drug_viscosity_pa_s != 0.0)
        options.drug_viscosity_pa_s = injection.drug_viscosity_pa_s;
    LaterTears now = tears_for_flow({0.0, injection.tears});
    options.tears = std::move(now.tears);
    options.tear_areas_mm2 = std::move(now.areas_mm2);
    options.tear_sides = std::move(now.sides);
    for (const TornSince& later : injection.later)
        options.later_tears.push_back(tears_for_flow(later));
    return options;
}

bool flows_like_blood(const InjectionOptions& options) {
    return drug_of(options) == pure(options.liquid);
}

DrugArrival drug_arrival(const VesselTree& tree, std::span<const TreePoint> places,
                         const InjectionOptions& options, Job& job) {
    const bool steady = flows_like_blood(options) && options.later_tears.empty();
    const Arrivals arrivals =
        steady ? steady_arrivals(tree, options) : stepped_arrivals(tree, options, job);
    std::vector<float> arrival_s(places.size());
    for (std::size_t v = 0; v < places.size(); ++v)
        arrival_s[v] = static_cast<float>(arrivals.times.arrival_s(places[v]));
    DrugArrival arrival;
    arrival.mass_error_relative = arrivals.mass_error_relative;
    const std::vector<TreePoint>& tears =
        options.later_tears.empty() ? options.tears : options.later_tears.back().tears;
    for (const TreePoint& tear : tears)
        arrival.at_tears_s.push_back(static_cast<float>(at_stumps_s(tree, arrivals.times, tear)));
    const bool leaks =
        std::ranges::any_of(arrival.at_tears_s, [](float time_s) { return std::isfinite(time_s); });
    // Doses and curves over time are computed until then.
    arrival.end_s = std::min({useful_end_s(arrival_s), longest_run_s,
                              longest_run_in_fillings * filling_s(tree, options)});
    if (!leaks) arrival.end_s = std::min(arrival.end_s, arrivals.times.end_s());
    // Vessels that tear later may end it at once.
    if (!(arrival.end_s > 0.0) && options.later_tears.empty())
        throw InputError("the drug would leave the vessels right where it is injected", "injection",
                         "Inject farther up the stream");
    arrival.arrival_s = std::make_shared<const std::vector<float>>(std::move(arrival_s));
    return arrival;
}

void cut_off(const VesselTree& tree, std::span<const TreePoint> places,
             const InjectionOptions& options, const LaterTears& later,
             std::vector<float>& arrival_s) {
    FlowNetwork network = network_of(tree, options.shape);
    FlowConditions unused;
    tear_for(torn_later(options, later), network, unused);
    const int tip = place_catheter(network, *options.tip, options.wedged);
    DisjointSets joined(static_cast<std::size_t>(network.node_count));
    for (const FlowSegment& s : network.segments)
        if (s.open)
            joined.unite(static_cast<std::uint32_t>(s.proximal_node),
                         static_cast<std::uint32_t>(s.distal_node));
    const std::uint32_t supplied = joined.root(static_cast<std::uint32_t>(tip));
    for (std::size_t v = 0; v < std::min(places.size(), arrival_s.size()); ++v) {
        if (!(static_cast<double>(arrival_s[v]) > later.from_s)) continue;
        const auto segment = static_cast<std::size_t>(locate(network, places[v]).segment);
        const int node = network.segments[segment].proximal_node;
        if (joined.root(static_cast<std::uint32_t>(node)) != supplied)
            arrival_s[v] = std::numeric_limits<float>::infinity();
    }
}

}  // namespace hepatica
