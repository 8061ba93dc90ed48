// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the components of a graph and removes the short ones.
#include "core/tree/extraction/component_pruning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hepatica {

namespace {

struct Component {
    double length_mm = 0.0;
    bool named = false;   // holds a link of a known system
    bool seeded = false;  // nearest to a seed or a kept place
};

// -1 where there are no links whose wall is within reach.
int link_nearest(const VesselGraph& graph, const Vec3& position_mm,
                 double reach_mm = std::numeric_limits<double>::infinity()) {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity(), radius_mm = 0.0;
    for (std::size_t id = 0; id < graph.links.size(); ++id) {
        const VesselLink& link = graph.links[id];
        for (std::size_t i = 0; i < link.points_mm.size(); ++i) {
            const double squared = (link.points_mm[i] - position_mm).squaredNorm();
            if (squared >= least) continue;
            least = squared;
            radius_mm = link.radii_mm[i];
            nearest = static_cast<int>(id);
        }
    }
    return std::sqrt(least) <= radius_mm + reach_mm ? nearest : -1;
}

std::vector<Component> components_of(const VesselGraph& graph, const std::vector<int>& of_node,
                                     const std::vector<VesselSeed>& seeds,
                                     const std::vector<Vec3>& kept_mm) {
    std::vector<Component> components(*std::ranges::max_element(of_node) + 1);
    for (const VesselLink& link : graph.links) {
        Component& component = components[of_node[link.from]];
        component.length_mm += length_mm(link);
        if (link.system != VascularSystem::unknown) component.named = true;
    }
    const auto keep = [&](int link) {
        if (link >= 0) components[of_node[graph.links[link].from]].seeded = true;
    };
    for (const VesselSeed& seed : seeds) keep(link_nearest(graph, seed.position_mm));
    for (const Vec3& place : kept_mm) keep(link_nearest(graph, place, kept_reach_mm));
    return components;
}

template <class Removes>
RemovedPieces remove_components(VesselGraph& graph, const std::vector<VesselSeed>& seeds,
                                const std::vector<Vec3>& kept_mm, const Removes& removes) {
    RemovedPieces removed;
    if (graph.links.empty()) return removed;
    const std::vector<int> of_node = component_of_nodes(graph);
    const std::vector<Component> components = components_of(graph, of_node, seeds, kept_mm);
    const auto longest = std::ranges::max_element(components, {}, &Component::length_mm);
    std::vector<std::uint8_t> goes(components.size(), 0);
    for (std::size_t c = 0; c < components.size(); ++c) {
        const bool is_longest = longest - components.begin() == static_cast<std::ptrdiff_t>(c);
        // A node that no link uses is a component of no length.
        if (!(components[c].length_mm > 0.0) || !removes(components[c], is_longest)) continue;
        goes[c] = 1;
        ++removed.count;
        removed.length_mm += components[c].length_mm;
    }
    std::vector<std::uint8_t> links(graph.links.size());
    for (std::size_t id = 0; id < links.size(); ++id)
        links[id] = goes[of_node[graph.links[id].from]];
    remove_links(graph, links);
    join_passing_nodes(graph);
    return removed;
}

}  // namespace

RemovedPieces remove_short_components(VesselGraph& graph, double shortest_mm,
                                      const std::vector<VesselSeed>& seeds,
                                      const std::vector<Vec3>& kept_mm) {
    return remove_components(
        graph, seeds, kept_mm, [&](const Component& component, bool is_longest) {
            const bool kept = is_longest || component.seeded || (!seeds.empty() && component.named);
            return !kept && component.length_mm < shortest_mm;
        });
}

}  // namespace hepatica
