// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/bleeding.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace hepatica {
namespace {

constexpr double murray_exponent = 3.0;

VascularSystem system_of_node(const VesselTree& tree, int node) {
    for (const VesselSegment& segment : tree.segments)
        if (segment.proximal_node == node || segment.distal_node == node) return segment.system;
    return VascularSystem::unknown;
}

// Whether the blood of one segment has come through another.
bool leads_to(const VesselTree& tree, int before, int segment) {
    while (segment >= 0 && segment != before)
        segment = tree.segments[static_cast<std::size_t>(segment)].parent;
    return segment == before;
}

// The share of the resting flow that enters at one root of a system: by the cube of its radius.
double share_of_root(const FlowNetwork& network, const std::vector<int>& roots, int root) {
    const auto cube = [&](int node) {
        double widest = 0.0;
        for (std::size_t s = 0; s < network.segments.size(); ++s)
            if (network.segments[s].proximal_node == node)
                widest = std::max(widest, proximal_radius_mm(network, static_cast<int>(s)));
        return widest * widest * widest;
    };
    double sum = 0.0;
    for (const int node : roots) sum += cube(node);
    return sum > 0.0 ? cube(root) / sum : 0.0;
}

// Resistances behind the outlets of one system that let its resting flow pass at its pressure.
void add_beds(const VesselTree& tree, const FlowNetwork& network, VascularSystem system,
              double flow_mm3_s, double pressure_pa, std::vector<double>& resistance) {
    double sum = 0.0;
    const auto weight = [&](int node) {
        double radius = 0.0;
        for (std::size_t s = 0; s < network.segments.size(); ++s)
            if (network.segments[s].distal_node == node)
                radius = distal_radius_mm(network, static_cast<int>(s));
        return std::pow(radius, murray_exponent);
    };
    for (std::size_t o = 0; o < network.outlet_nodes.size(); ++o)
        if (system_of_node(tree, network.outlet_nodes[o]) == system)
            sum += weight(network.outlet_nodes[o]);
    for (std::size_t o = 0; o < network.outlet_nodes.size(); ++o)
        if (system_of_node(tree, network.outlet_nodes[o]) == system)
            resistance[o] = pressure_pa / flow_mm3_s * sum / weight(network.outlet_nodes[o]);
}

// Resting inflow at the roots, distributed by their calibre; beds behind the ends.
FlowConditions conditions_of(const VesselTree& tree, const RestingFlow& rest,
                             const FlowNetwork& network) {
    FlowConditions conditions;
    conditions.law = PressureLaw::regime;
    conditions.resident = pure(blood());
    conditions.ambient_pressure_pa = rest.ambient_pa;
    const double density = conditions.resident.density_g_mm3;
    conditions.terminal_resistances.assign(network.outlet_nodes.size(),
                                           std::numeric_limits<double>::infinity());
    add_beds(tree, network, VascularSystem::portal, rest.portal_g_s / density, rest.portal_pa,
             conditions.terminal_resistances);
    add_beds(tree, network, VascularSystem::artery, rest.artery_g_s / density, rest.artery_pa,
             conditions.terminal_resistances);
    for (const VascularSystem system :
         {VascularSystem::portal, VascularSystem::artery, VascularSystem::hepatic}) {
        std::vector<int> roots;
        for (const int node : network.root_nodes)
            if (system_of_node(tree, node) == system) roots.push_back(node);
        for (const int node : roots) {
            if (system == VascularSystem::hepatic) {
                conditions.inlets.push_back(
                    {node, InletKind::pressure, rest.cava_pa, conditions.resident});
                continue;
            }
            const double flow =
                system == VascularSystem::portal ? rest.portal_g_s : rest.artery_g_s;
            conditions.inlets.push_back({node, InletKind::mass_flow,
                                         flow * share_of_root(network, roots, node),
                                         conditions.resident});
        }
    }
    return conditions;
}

// The pools of these tears, then what lies elsewhere. A tear that grows may move along its vessel,
// and stays the same.
std::vector<BloodPool> handed_over(const std::vector<BloodPool>& from,
                                   const std::vector<ThroughTear>& to) {
    constexpr double same_mm = 3.0;
    std::vector<BloodPool> pools;
    for (const ThroughTear& tear : to) pools.push_back({.of = tear});
    std::vector<std::uint8_t> known(to.size(), 0), taken(from.size(), 0);
    for (const double within_mm : {0.0, same_mm}) {
        for (std::size_t i = 0; i < to.size(); ++i) {
            if (known[i] != 0) continue;
            double least_mm = within_mm;
            std::size_t nearest = from.size();
            for (std::size_t j = 0; j < from.size(); ++j) {
                const TreePoint& there = from[j].of.at;
                if (taken[j] != 0 || there.segment != to[i].at.segment) continue;
                const double mm = std::abs(there.arclength_mm - to[i].at.arclength_mm);
                if (mm > least_mm) continue;
                least_mm = mm;
                nearest = j;
            }
            if (nearest == from.size()) continue;
            known[i] = taken[nearest] = 1;
            pools[i].lost_g = from[nearest].lost_g;
            pools[i].drug_g = from[nearest].drug_g;
        }
    }
    for (std::size_t j = 0; j < from.size(); ++j)
        if (taken[j] == 0 && from[j].lost_g > 0.0) pools.push_back(from[j]);
    return pools;
}

}  // namespace

double resting_pressure_pa(VascularSystem system, const RestingFlow& rest) {
    switch (system) {
        case VascularSystem::artery:
            return rest.artery_pa;
        case VascularSystem::hepatic:
            return rest.cava_pa;
        default:
            return rest.portal_pa;
    }
}

Bleeding::Bleeding(const VesselTree& tree, const RestingFlow& rest) : tree_(tree), rest_(rest) {}

void Bleeding::set_tears(const std::vector<ThroughTear>& tears) {
    constexpr auto area = &ThroughTear::area_mm2;
    if (tears == tears_ && std::ranges::equal(tears, tears_, {}, area, area)) return;
    pools_ = handed_over(pools_, tears);
    tears_ = tears;
    if (tears_.empty()) squeezes_.clear();  // nobody says what presses while nothing is torn
    solve();
}

void Bleeding::step(double dt_s) {
    leaked_g_ += leak_g_s_ * dt_s;
    for (std::size_t i = 0; i < tears_.size(); ++i) pools_[i].lost_g += leaks_g_s_[i] * dt_s;
}

void Bleeding::leak_drug(double drug_g, const std::vector<double>& shares) {
    leaked_drug_g_ += drug_g;
    for (std::size_t i = 0; i < std::min(shares.size(), tears_.size()); ++i)
        pools_[i].drug_g += shares[i] * drug_g;
}

void Bleeding::set_leaked_g(double leaked_g) {
    leaked_g_ = leaked_g;
    pools_ = handed_over({}, tears_);
}

void Bleeding::set_pools(const std::vector<BloodPool>& pools) {
    pools_ = handed_over(pools, tears_);
}

std::vector<double> Bleeding::shares_of_loss() const {
    std::vector<double> shares;
    for (const BloodPool& pool : pools_) shares.push_back(pool.lost_g);
    double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    if (!(sum > 0.0)) {
        shares = leaks_g_s_;
        sum = leak_g_s_;
    }
    for (double& share : shares) share = sum > 0.0 ? share / sum : 0.0;
    return shares;
}

double Bleeding::pressure_in(int segment) const {
    return resting_pressure_pa(tree_.segments[static_cast<std::size_t>(segment)].system, rest_);
}

// Shares are rounded to steps, so that a held tool does not cause a new solution at every step.
void Bleeding::set_pressed(const std::vector<PressedStretch>& stretches, const TubeWall& wall) {
    std::vector<Squeeze> squeezes;
    for (const PressedStretch& pressed : stretches) {
        const double share = open_share(pressed.pressure_pa - pressure_in(pressed.segment), wall);
        const double in_steps = std::exp2(0.5 * std::round(2.0 * std::log2(share)));
        if (in_steps < 1.0)
            squeezes.push_back(
                {pressed.segment, std::floor(pressed.from_mm), std::ceil(pressed.to_mm), in_steps});
    }
    if (squeezes == squeezes_) return;
    squeezes_ = std::move(squeezes);
    if (!tears_.empty()) solve();
}

// What presses behind a tear through the vessel holds nothing back: no blood comes there. Loops are
// left out.
bool Bleeding::lies_before_a_tear(const Squeeze& squeeze) const {
    const auto is_cut_off = [&](const ThroughTear& tear) {
        return !tear.side && (tear.at.segment == squeeze.segment
                                  ? tear.at.arclength_mm < squeeze.from_mm
                                  : leads_to(tree_, tear.at.segment, squeeze.segment));
    };
    const auto is_fed = [&](const ThroughTear& tear) {
        return tear.at.segment == squeeze.segment
                   ? squeeze.from_mm <= tear.at.arclength_mm
                   : leads_to(tree_, squeeze.segment, tear.at.segment);
    };
    return std::ranges::any_of(tears_, is_fed) && std::ranges::none_of(tears_, is_cut_off);
}

PressedLumen Bleeding::most_pressed(bool before_a_tear) const {
    PressedLumen most;
    for (const Squeeze& squeeze : squeezes_)
        if (squeeze.share < most.open_share && lies_before_a_tear(squeeze) == before_a_tear)
            most = {squeeze.segment, squeeze.share};
    return most;
}

// A pump of fixed flow would press blood through a vessel that is almost closed; arteries cannot.
// The inflow of a system falls linearly from its resting value to 0 while the pressure at its inlet
// rises from the resting one to that of the aorta. Finds the share of the resting inflow at which
// both agree, by bisection.
void Bleeding::limit_inflow(NetworkFlow& flow, const FlowConditions& conditions,
                            VascularSystem system) const {
    const double rest_pa = system == VascularSystem::portal ? rest_.portal_pa : rest_.artery_pa;
    std::vector<int> inlets;
    for (std::size_t i = 0; i < conditions.inlets.size(); ++i)
        if (conditions.inlets[i].kind == InletKind::mass_flow &&
            system_of_node(tree_, conditions.inlets[i].node) == system)
            inlets.push_back(static_cast<int>(i));
    const auto too_much = [&](double share) {
        for (const int i : inlets)
            flow.drive(i, share * conditions.inlets[static_cast<std::size_t>(i)].value);
        const FlowSolution& solution = flow.solve();
        double pressure_pa = 0.0;
        for (const int i : inlets)
            pressure_pa =
                std::max(pressure_pa, solution.inlet_pressure_pa[static_cast<std::size_t>(i)]);
        return pressure_pa > rest_.aorta_pa - share * (rest_.aorta_pa - rest_pa);
    };
    if (inlets.empty() || !too_much(1.0)) return;
    constexpr int halvings = 10;
    double low = 0.0, high = 1.0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (too_much(middle) ? high : low) = middle;
    }
    too_much(low);
}

void Bleeding::solve() {
    leak_g_s_ = 0.0;
    leaks_g_s_.assign(tears_.size(), 0.0);
    if (tears_.empty()) return;
    FlowNetwork network = network_of(tree_);
    const FlowConditions conditions = conditions_of(tree_, rest_, network);
    for (const Squeeze& s : squeezes_) squeeze(network, s.segment, s.from_mm, s.to_mm, s.share);
    FlowConditions torn = conditions;
    std::vector<TreePoint> points;
    std::vector<double> areas_mm2;
    std::vector<std::uint8_t> sides;
    for (const ThroughTear& one : tears_) {
        points.push_back(one.at);
        areas_mm2.push_back(one.area_mm2);
        sides.push_back(one.side ? 1 : 0);
    }
    const std::vector<int> outlets = network.outlet_nodes;
    const std::vector<TearOpening> openings = tear_all(network, points, areas_mm2, sides);
    torn.terminal_resistances = of_outlets_left(network, outlets, conditions.terminal_resistances);
    torn.torn_areas_mm2 = torn_areas_mm2(network, openings);
    NetworkFlow flow(network, torn);
    FlowSolution solution = flow.solve();
    if (!squeezes_.empty()) {
        for (const VascularSystem system : {VascularSystem::portal, VascularSystem::artery})
            limit_inflow(flow, torn, system);
        solution = flow.solution();
    }
    const double density = torn.resident.density_g_mm3;
    for (const double out : solution.torn_flow_mm3_s) leak_g_s_ += out * density;
    for (const TearOpening& one : openings)
        leaks_g_s_[one.tear] += solution.torn_flow_mm3_s[one.torn_node] * density *
                                (one.area_mm2 / torn.torn_areas_mm2[one.torn_node]);
}

}  // namespace hepatica
