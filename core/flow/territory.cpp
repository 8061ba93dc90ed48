// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/territory.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace hepatica {
namespace {

// Nodes by falling total pressure. Flow falls with it, so that every inflow of a node comes before
// its outflows.
std::vector<int> downstream_order(const FlowNetwork& network, const FlowSolution& solution) {
    std::vector<int> falling(network.node_count);
    std::iota(falling.begin(), falling.end(), 0);
    std::ranges::stable_sort(falling, std::ranges::greater{},
                             [&](int node) { return solution.total_pressure_pa[node]; });
    return falling;
}

double entering_flow(const FlowSolution& solution) {
    double entering = 0.0;
    for (const double q : solution.inlet_flow_mm3_s) entering += std::max(q, 0.0);
    for (const double q : solution.outlet_flow_mm3_s) entering += std::max(-q, 0.0);
    return entering;
}

// Propagates the share that has passed the point downstream, from the segment of the point in
// `passed_share` to all others; returns the share at each node.
std::vector<double> carry_downstream(const FlowNetwork& network, const FlowSolution& solution,
                                     int start, std::vector<double>& passed_share) {
    const std::vector<double>& flow = solution.volume_flow_mm3_s;
    const NodeSegments at = segments_at_nodes(network);
    std::vector<double> share_at_node(network.node_count, 0.0);
    for (const int node : downstream_order(network, solution)) {
        double in = 0.0, passed = 0.0, out = 0.0;
        for (int i = at.first[node]; i < at.first[node + 1]; ++i) {
            const int id = at.segments[i];
            const bool inwards = (network.segments[id].distal_node == node) == (flow[id] > 0.0);
            if (inwards) {
                in += std::abs(flow[id]);
                passed += std::abs(flow[id]) * passed_share[id];
            } else {
                out += std::abs(flow[id]);
            }
        }
        // Fluid that an inlet adds at this node has not passed the point.
        const double through = std::max(in, out);
        share_at_node[node] = through > 0.0 ? passed / through : 0.0;
        for (int i = at.first[node]; i < at.first[node + 1]; ++i) {
            const int id = at.segments[i];
            const bool outwards = (network.segments[id].proximal_node == node) == (flow[id] > 0.0);
            if (outwards && id != start && flow[id] != 0.0) passed_share[id] = share_at_node[node];
        }
    }
    return share_at_node;
}

}  // namespace

Territory territory_of(const FlowNetwork& network, const FlowSolution& solution,
                       const TreePoint& point) {
    const auto [start, arclength] = locate(network, point);
    const std::vector<double>& flow = solution.volume_flow_mm3_s;
    Territory territory;
    territory.segment = start;
    territory.begins_mm = arclength;
    territory.flow_mm3_s = std::abs(flow[start]);
    territory.passed_share.assign(network.segments.size(), 0.0);
    territory.passed_share[start] = 1.0;

    const std::vector<double> share_at_node =
        carry_downstream(network, solution, start, territory.passed_share);
    double leaving = 0.0;
    double passed = 0.0;
    for (std::size_t o = 0; o < network.outlet_nodes.size(); ++o) {
        const double q = std::max(solution.outlet_flow_mm3_s[o], 0.0);
        const double share = share_at_node[network.outlet_nodes[o]];
        leaving += q;
        passed += q * share;
        if (q * share <= 0.0) continue;
        territory.outlets.push_back(static_cast<int>(o));
        territory.outlet_shares.push_back(share);
    }
    territory.share_of_outflow = leaving > 0.0 ? passed / leaving : 0.0;
    const double entering = entering_flow(solution);
    territory.share_of_flow = entering > 0.0 ? territory.flow_mm3_s / entering : 0.0;
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
        const int id = static_cast<int>(i);
        if (territory.passed_share[i] == 0.0) continue;
        double volume = volume_mm3(network, id);
        if (id == start) {
            const double before = volume_up_to_mm3(network, id, arclength);
            volume = flow[id] >= 0.0 ? volume - before : before;
        }
        territory.volume_mm3 += territory.passed_share[i] * volume;
    }
    return territory;
}

}  // namespace hepatica
