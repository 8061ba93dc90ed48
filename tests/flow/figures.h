// SPDX-License-Identifier: GPL-3.0-or-later
// Results of flow as rows of numbers, for recorded figures: infinity, which is not recorded, stands
// as -1.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/flow/embolization.h"
#include "core/flow/injection.h"
#include "tests/flow/random_cases.h"
#include "tests/support/recorded_figures.h"

namespace hepatica::testing_flow {

inline double finite(double value) {
    return std::isfinite(value) ? value : -1.0;
}

inline void add_solution(test::Figures& figures, const std::string& name,
                         const FlowSolution& solution) {
    figures.add(name + ".flow", solution.volume_flow_mm3_s)
        .add(name + ".mass", solution.mass_flow_g_s)
        .add(name + ".pressure", solution.total_pressure_pa)
        .add(name + ".outlets", solution.outlet_flow_mm3_s)
        .add(name + ".torn", solution.torn_flow_mm3_s)
        .add(name + ".inlets", solution.inlet_flow_mm3_s)
        .add(name + ".inlet_pressure", solution.inlet_pressure_pa);
}

inline void add_network(test::Figures& figures, const std::string& name,
                        const FlowNetwork& network) {
    std::vector<double> numbers{static_cast<double>(network.node_count)};
    for (const FlowSegment& s : network.segments)
        for (const double value :
             {static_cast<double>(s.proximal_node), static_cast<double>(s.distal_node),
              static_cast<double>(s.first_cone), static_cast<double>(s.cone_count),
              static_cast<double>(s.tree_segment), s.offset_mm, s.open ? 1.0 : 0.0})
            numbers.push_back(value);
    for (const Cone& c : network.cones)
        numbers.insert(numbers.end(), {c.proximal_radius_mm, c.distal_radius_mm, c.length_mm});
    for (const auto* nodes : {&network.root_nodes, &network.outlet_nodes, &network.torn_nodes})
        numbers.insert(numbers.end(), nodes->begin(), nodes->end());
    figures.add(name, numbers);
}

inline void add_arrivals(test::Figures& figures, const std::string& name,
                         const FlowNetwork& network, const ArrivalTimes& times) {
    std::vector<double> numbers{finite(times.end_s())};
    for (int s = 0; s < static_cast<int>(network.segments.size()); ++s) {
        numbers.push_back(finite(times.first_s(s)));
        // At the later of both ends.
        const double ends_s =
            std::max(times.arrival_s(s, 0.0), times.arrival_s(s, length_mm(network, s)));
        numbers.push_back(finite(ends_s));
        for (const double share : {0.1, 0.5, 0.9})
            numbers.push_back(finite(times.arrival_s(s, share * length_mm(network, s))));
    }
    figures.add(name, numbers);
}

// Straight cones made uneven: bent, and of radii that no line meets.
inline VesselTree uneven_tree(std::uint64_t seed, int generations) {
    VesselTree tree = make_tree(seed, generations);
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        VesselSegment& segment = tree.segments[s];
        for (std::size_t i = 1; i + 1 < segment.points_mm.size(); ++i) {
            const double phase = static_cast<double>(3 * s + i);
            segment.points_mm[i].y() += 0.1 * std::sin(phase);
            segment.radii_mm[i] *= 1.0 + 0.15 * std::sin(1.7 * phase);
        }
    }
    validate(tree);
    return tree;
}

}  // namespace hepatica::testing_flow
