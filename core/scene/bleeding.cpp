// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/bleeding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hepatica {
namespace {

constexpr double murray_exponent = 3.0;

VascularSystem system_of_node(const VesselTree& tree, int node) {
    for (const VesselSegment& segment : tree.segments)
        if (segment.proximal_node == node || segment.distal_node == node) return segment.system;
    return VascularSystem::unknown;
}

// The part of the resting flow that enters at each root of a system: by its calibre.
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

// Resistances behind the outlets of one system that its resting flow takes at its pressure.
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

}  // namespace

Bleeding::Bleeding(const VesselTree& tree, const RestingFlow& rest) : tree_(tree), rest_(rest) {}

void Bleeding::set_tears(const std::vector<ThroughTear>& tears) {
    if (tears == tears_) return;
    tears_ = tears;
    leak_g_s_ = 0.0;
    leaks_g_s_.assign(tears.size(), 0.0);
    if (tears.empty()) return;
    FlowNetwork network = network_of(tree_);
    const std::vector<int> outlets = network.outlet_nodes;
    FlowConditions conditions;
    conditions.law = PressureLaw::regime;
    conditions.resident = pure(blood());
    conditions.ambient_pressure_pa = rest_.ambient_pa;
    const double density = conditions.resident.density_g_mm3;
    conditions.terminal_resistances.assign(outlets.size(), std::numeric_limits<double>::infinity());
    add_beds(tree_, network, VascularSystem::portal, rest_.portal_g_s / density, rest_.portal_pa,
             conditions.terminal_resistances);
    add_beds(tree_, network, VascularSystem::artery, rest_.artery_g_s / density, rest_.artery_pa,
             conditions.terminal_resistances);
    for (const VascularSystem system :
         {VascularSystem::portal, VascularSystem::artery, VascularSystem::hepatic}) {
        std::vector<int> roots;
        for (const int node : network.root_nodes)
            if (system_of_node(tree_, node) == system) roots.push_back(node);
        for (const int node : roots) {
            if (system == VascularSystem::hepatic) {
                conditions.inlets.push_back(
                    {node, InletKind::pressure, rest_.cava_pa, conditions.resident});
                continue;
            }
            const double flow =
                system == VascularSystem::portal ? rest_.portal_g_s : rest_.artery_g_s;
            conditions.inlets.push_back({node, InletKind::mass_flow,
                                         flow * share_of_root(network, roots, node),
                                         conditions.resident});
        }
    }
    std::vector<std::size_t> tear_of_stump;
    for (const ThroughTear& torn : tears) {
        const std::size_t before = network.torn_nodes.size();
        tear(network, torn.at);
        conditions.torn_areas_mm2.resize(
            conditions.torn_areas_mm2.size() + network.torn_nodes.size() - before, torn.area_mm2);
        tear_of_stump.resize(network.torn_nodes.size(),
                             static_cast<std::size_t>(&torn - tears.data()));
    }
    const FlowSolution solution = solve_flow(network, conditions);
    for (const double flow : solution.torn_flow_mm3_s) leak_g_s_ += flow * density;
    for (std::size_t i = 0; i < tear_of_stump.size(); ++i)
        leaks_g_s_[tear_of_stump[i]] += solution.torn_flow_mm3_s[i] * density;
}

}  // namespace hepatica
