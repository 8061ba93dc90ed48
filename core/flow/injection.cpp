// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/injection.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <utility>

#include "core/base/error.h"

namespace hepatica {

namespace {

constexpr double most_samples = 1e5;
constexpr double least_flow_g_s = 1e-12, most_flow_g_s = 1e15;

void check(const char* what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    std::ostringstream problem;
    std::ostringstream remedy;
    problem << "the " << what << " is " << value;
    remedy << "Give a value from " << low << " to " << high;
    throw InputError(problem.str(), "injection", remedy.str());
}

void validate_options(const InjectionOptions& options) {
    if (options.inlet_pressure_pa)
        check("mass flow in g/s", options.mass_flow_g_s, 0.0, most_flow_g_s);
    else
        validate_drug_flow(options.mass_flow_g_s);
    check("flow of blood in g/s", options.blood_flow_g_s, 0.0, most_flow_g_s);
    if (options.step_s) check("time between samples in s", *options.step_s, 1e-9, 1e9);
    if (options.until_s) check("end in s", *options.until_s, 0.0, longest_run_s);
    check("duration of the injection in s", options.injection_s, 0.0, HUGE_VAL);
    if (options.inlet_pressure_pa && !(*options.inlet_pressure_pa > options.outlet_pressure_pa)) {
        std::ostringstream problem;
        problem << "the pressure at the tip (--pressure-pa) is " << *options.inlet_pressure_pa
                << " Pa and not above the " << options.outlet_pressure_pa
                << " Pa beyond the outlets (--outlet-pressure-pa): nothing would be injected";
        throw InputError(problem.str(), "injection", "Give a higher pressure, or a mass flow");
    }
    check("terminal resistance in Pa s/mm3", options.terminal_resistance_pa_s_mm3, 0.0, 1e12);
    double last_s = 0.0;
    for (const LaterTears& later : options.later_tears) {
        check("time of a tear in s", later.from_s, last_s, longest_run_s);
        last_s = later.from_s;
    }
}

// The vessels without tears, divided wherever something tears later, so that a tear joins the same
// segments otherwise.
FlowNetwork whole_network(const VesselTree& tree, const InjectionOptions& options,
                          const TreePoint& tip) {
    FlowNetwork network = network_of(tree, options.shape);
    if (tip.segment < 0 || tip.segment >= static_cast<int>(tree.segments.size()))
        throw InputError("there is no segment " + std::to_string(tip.segment), "injection",
                         "Choose a point on the vessel tree");
    for (const int closed : options.closed_segments) {
        if (closed < 0 || closed >= static_cast<int>(tree.segments.size()))
            throw InputError("there is no segment " + std::to_string(closed), "injection",
                             "Close a segment of the vessel tree");
        set_open(network, closed, false);
    }
    if (options.later_tears.empty()) return network;
    for (const TreePoint& point : options.tears) divide(network, point);
    for (const LaterTears& later : options.later_tears)
        for (const TreePoint& point : later.tears) divide(network, point);
    divide(network, tip);
    return network;
}

struct DrivenNetwork {
    FlowNetwork network;
    FlowConditions conditions;
    int tip_node = -1;
};

// Tears the vessels, places the catheter and sets what drives the flow. The drug is inlet 0.
DrivenNetwork driven(const VesselTree& tree, const InjectionOptions& options,
                     const FlowNetwork& whole, const TreePoint& tip, const Fluid& drug) {
    DrivenNetwork made{whole, {}, -1};
    FlowNetwork& network = made.network;
    FlowConditions& conditions = made.conditions;
    tear_for(options, network, conditions);
    made.tip_node = place_catheter(network, tip, options.wedged);
    conditions.law = options.law;
    conditions.resident = pure(options.liquid);
    conditions.outlet_pressure_pa = options.outlet_pressure_pa;
    conditions.bifurcation_loss_coefficient = options.bifurcation_loss_coefficient;
    // Those of the whole vessels: the beds of those that are left do not widen where an end is torn
    // off.
    if (options.terminal_resistance_pa_s_mm3 > 0.0)
        conditions.terminal_resistances = of_outlets_left(
            network, whole.outlet_nodes,
            murray_terminal_resistances(whole, options.terminal_resistance_pa_s_mm3));
    if (options.inlet_pressure_pa)
        conditions.inlets.push_back(
            {made.tip_node, InletKind::pressure, *options.inlet_pressure_pa, drug});
    else
        conditions.inlets.push_back(
            {made.tip_node, InletKind::mass_flow, options.mass_flow_g_s, drug});
    if (!options.wedged && options.blood_flow_g_s > 0.0) {
        int root = tip.segment;
        while (tree.segments[root].parent >= 0) root = tree.segments[root].parent;
        conditions.inlets.push_back({tree.segments[root].proximal_node, InletKind::mass_flow,
                                     options.blood_flow_g_s, conditions.resident});
    }
    return made;
}

// Tears the vessels of a front when it is time.
class LaterTearing {
  public:
    LaterTearing(const VesselTree& tree, const InjectionOptions& options, const FlowNetwork& whole,
                 const TreePoint& tip, int tip_node, const Fluid& drug)
        : tree_(tree),
          options_(options),
          whole_(whole),
          tip_(tip),
          tip_node_(tip_node),
          drug_(drug) {}

    // Infinity: nothing tears any more.
    double next_s() const {
        return next_ < options_.later_tears.size() ? options_.later_tears[next_].from_s
                                                   : std::numeric_limits<double>::infinity();
    }
    void tear_what_is_due(DrugFront& front) {
        const LaterTears* due = nullptr;
        while (next_s() <= front.time_s()) due = &options_.later_tears[next_++];
        if (due == nullptr) return;
        DrivenNetwork now = driven(tree_, torn_later(options_, *due), whole_, tip_, drug_);
        tip_node_ = now.tip_node;
        if (!front.injecting()) now.conditions.inlets.erase(now.conditions.inlets.begin());
        front.rejoin(std::move(now.network), std::move(now.conditions));
    }
    // Of the network as it is torn now.
    int tip_node() const { return tip_node_; }

  private:
    const VesselTree& tree_;
    const InjectionOptions& options_;
    const FlowNetwork& whole_;
    const TreePoint tip_;
    int tip_node_;
    const Fluid drug_;
    std::size_t next_ = 0;
};

// The drug in that part of a segment that belongs to the territory: of the segment of its point
// only what lies downstream of it.
double territory_drug_mm3(const InjectionResult& injection, const DrugFront& front,
                          const Territory& territory, int segment) {
    const double whole = front.drug_mm3(segment);
    if (segment != territory.segment) return whole;
    const double proximal = front.drug_up_to_mm3(
        segment, volume_up_to_mm3(injection.network, segment, territory.begins_mm));
    const bool distally = injection.begin.volume_flow_mm3_s[segment] >= 0.0;
    return distally ? std::max(0.0, whole - proximal) : proximal;
}

double territory_mass_g(const InjectionResult& injection, const DrugFront& front,
                        const Territory& territory) {
    double mass = 0.0;
    for (std::size_t i = 0; i < territory.passed_share.size(); ++i)
        if (territory.passed_share[i] > 0.0)
            mass += territory.passed_share[i] *
                    territory_drug_mm3(injection, front, territory, static_cast<int>(i)) *
                    injection.drug.density_g_mm3;
    for (std::size_t k = 0; k < territory.outlets.size(); ++k) {
        const int node = injection.network.outlet_nodes[territory.outlets[k]];
        const auto at = std::ranges::lower_bound(injection.outlet_nodes, node);
        mass +=
            territory.outlet_shares[k] * front.outlet_mass_g()[at - injection.outlet_nodes.begin()];
    }
    return mass;
}

InjectionSample sample(const InjectionResult& injection, const DrugFront& front, int tip_node,
                       double tree_mm3, std::size_t tree_segments, bool filled_lengths) {
    const double density = injection.drug.density_g_mm3;
    const DrugBalance balance = front.balance();
    InjectionSample s;
    s.time_s = front.time_s();
    s.inlet_pressure_pa = front.flow().total_pressure_pa[tip_node];
    s.inlet_flow_g_s = front.injecting() ? front.flow().inlet_flow_mm3_s[0] * density : 0.0;
    s.injected_g = balance.injected_mm3 * density;
    s.inside_g = balance.inside_mm3 * density;
    s.delivered_g = balance.left_mm3 * density;
    s.bled_g = balance.bled_mm3 * density;
    s.filled_fraction = tree_mm3 > 0.0 ? balance.inside_mm3 / tree_mm3 : 0.0;
    s.outlet_mass_g = front.outlet_mass_g();
    for (const Territory& territory : injection.territories)
        s.territory_mass_g.push_back(territory_mass_g(injection, front, territory));
    if (filled_lengths) {
        s.filled_length_mm.assign(tree_segments, 0.0f);
        for (std::size_t i = 0; i < injection.network.segments.size(); ++i)
            s.filled_length_mm[injection.network.segments[i].tree_segment] +=
                static_cast<float>(front.filled_length_mm(static_cast<int>(i)));
    }
    return s;
}

}  // namespace

void validate_drug_flow(double mass_flow_g_s) {
    check("mass flow in g/s", mass_flow_g_s, least_flow_g_s, most_flow_g_s);
}

InjectionOptions torn_later(const InjectionOptions& options, const LaterTears& later) {
    InjectionOptions torn = options;
    torn.tears = later.tears;
    torn.tear_areas_mm2 = later.areas_mm2;
    torn.tear_sides = later.sides;
    torn.later_tears.clear();
    return torn;
}

void tear_for(const InjectionOptions& options, FlowNetwork& network, FlowConditions& conditions) {
    assert(options.tear_sides.empty() ||
           options.tear_sides.size() == options.tear_areas_mm2.size());
    if (options.tear_areas_mm2.empty()) {
        for (const TreePoint& point : options.tears) tear(network, point);
        return;
    }
    assert(options.tear_areas_mm2.size() == options.tears.size());
    const std::vector<TearOpening> openings =
        tear_all(network, options.tears, options.tear_areas_mm2, options.tear_sides);
    conditions.torn_areas_mm2 = torn_areas_mm2(network, openings);
}

Fluid drug_of(const InjectionOptions& options) {
    Fluid drug = mixture(options.liquid, options.second_phase, options.void_fraction);
    if (options.drug_viscosity_pa_s) drug.viscosity_pa_s = *options.drug_viscosity_pa_s;
    validate(drug);
    return drug;
}

namespace {

// Order of preference: blood and injected fluids reach the liver through arteries and the portal
// vein.
int entry_rank(VascularSystem system) {
    switch (system) {
        case VascularSystem::artery:
            return 0;
        case VascularSystem::portal:
            return 1;
        case VascularSystem::unknown:
            return 2;
        case VascularSystem::hepatic:
            return 3;
    }
    return 4;
}

}  // namespace

TreePoint main_root(const VesselTree& tree) {
    if (tree.segments.empty())
        throw InputError("the vessel tree has no segments", "injection",
                         "Reconstruct the patient first");
    std::vector<double> volume(tree.segments.size(), 0.0);
    const FlowNetwork network = network_of(tree);
    const auto better = [&](int i, int than) {
        const int rank = entry_rank(tree.segments[i].system);
        const int other = entry_rank(tree.segments[than].system);
        return rank != other ? rank < other : volume[i] >= volume[than];
    };
    int best = -1;
    for (std::size_t i = tree.segments.size(); i-- > 0;) {
        volume[i] += volume_mm3(network, static_cast<int>(i));
        const int parent = tree.segments[i].parent;
        if (parent >= 0)
            volume[parent] += volume[i];
        else if (!tree.segments[i].closes_loop && (best < 0 || better(static_cast<int>(i), best)))
            best = static_cast<int>(i);
    }
    return {std::max(best, 0), 0.0, 0.0};
}

InjectionResult inject(const VesselTree& tree, const InjectionOptions& options, Job& job,
                       const std::function<void(const InjectionResult&)>& sampled) {
    job.begin_stage("injection");
    validate_options(options);
    InjectionResult injection;
    const TreePoint tip = options.tip ? *options.tip : main_root(tree);
    const FlowNetwork whole = whole_network(tree, options, tip);
    injection.drug = drug_of(options);
    DrivenNetwork start = driven(tree, options, whole, tip, injection.drug);
    injection.network = std::move(start.network);
    injection.conditions = std::move(start.conditions);
    injection.outlet_nodes = whole.outlet_nodes;
    injection.tip_node = start.tip_node;
    LaterTearing tearing(tree, options, whole, tip, injection.tip_node, injection.drug);
    FrontOptions front_options = options.front;
    front_options.injection_end_s = options.injection_s;
    DrugFront front(injection.network, injection.conditions, 0, front_options,
                    injection.outlet_nodes);
    injection.begin = front.flow();
    for (const TreePoint& point : options.territories)
        injection.territories.push_back(territory_of(injection.network, injection.begin, point));

    const double tree_mm3 = volume_mm3(injection.network);
    double entering = 0.0;
    for (const double q : injection.begin.inlet_flow_mm3_s) entering += std::abs(q);
    const double filling_s = entering > 0.0 ? tree_mm3 / entering : 0.0;
    double until = options.until_s.value_or(longest_run_in_fillings * filling_s);
    if (!options.until_s && std::isfinite(options.injection_s)) until += options.injection_s;
    double interval = options.step_s.value_or(filling_s / 100.0);
    interval = interval > 0.0 ? std::max(interval, until / most_samples) : until;
    const auto record = [&] {
        injection.series.push_back(sample(injection, front, tearing.tip_node(), tree_mm3,
                                          tree.segments.size(), options.record_filled_lengths));
        if (sampled) sampled(injection);
    };
    record();
    tearing.tear_what_is_due(front);
    for (std::size_t k = 1; front.time_s() < until; ++k) {
        const double to = std::min(static_cast<double>(k) * interval, until);
        while (front.time_s() < to) {
            front.step_towards(std::min(to, tearing.next_s()));
            job.throw_if_cancelled();
            tearing.tear_what_is_due(front);
        }
        record();
        const bool injecting_for_ever = std::isinf(options.injection_s);
        if (!options.until_s && front.at_rest() && std::isinf(tearing.next_s()) &&
            (injecting_for_ever || !front.injecting()))
            break;
        job.advance(std::max(front.time_s() / until, injection.series.back().filled_fraction));
    }
    injection.end = front.flow();
    injection.arrival = front.arrival_times();
    injection.balance = front.balance();
    injection.steps = front.steps();
    return injection;
}

double end_flow_g_s(const InjectionResult& injection, int tree_segment) {
    double flow = injection.end.mass_flow_g_s[tree_segment];
    for (std::size_t i = injection.network.segments.size(); i-- > 0;) {
        const FlowSegment& s = injection.network.segments[i];
        if (s.tree_segment == static_cast<int>(i)) break;
        if (s.tree_segment == tree_segment &&
            std::abs(injection.end.mass_flow_g_s[i]) > std::abs(flow))
            flow = injection.end.mass_flow_g_s[i];
    }
    return flow;
}

double first_arrival_s(const InjectionResult& injection, int tree_segment) {
    double first = injection.arrival.first_s(tree_segment);
    for (std::size_t i = injection.network.segments.size(); i-- > 0;) {
        const FlowSegment& s = injection.network.segments[i];
        if (s.tree_segment == static_cast<int>(i)) break;
        if (s.tree_segment == tree_segment)
            first = std::min(first, injection.arrival.first_s(static_cast<int>(i)));
    }
    return first;
}

}  // namespace hepatica
