// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/spur_pruning.h"

#include <algorithm>
#include <limits>

namespace hepatica {

namespace {

void remove_links(VesselGraph& graph, const std::vector<std::uint8_t>& removed) {
    std::vector<VesselLink> kept;
    for (std::size_t i = 0; i < graph.links.size(); ++i)
        if (removed[i] == 0) kept.push_back(std::move(graph.links[i]));
    graph.links = std::move(kept);
}

// How many of the parent's radii an end link reaches beyond the parent's wall; infinite for links
// that are no end links or are long enough to be vessels.
double reach_in_radii(const VesselGraph& graph, const std::vector<std::vector<int>>& at_node,
                      int id, double shortest_mm, double spur_radii) {
    const VesselLink& link = graph.links[id];
    const bool from_is_end = at_node[link.from].size() == 1;
    const bool to_is_end = at_node[link.to].size() == 1;
    constexpr double never = std::numeric_limits<double>::infinity();
    if (from_is_end == to_is_end) return never;
    const double wall_mm = graph.nodes[from_is_end ? link.to : link.from].radius_mm;
    const double beyond_mm = length_mm(link) - wall_mm;
    if (beyond_mm >= std::max(shortest_mm, spur_radii * wall_mm)) return never;
    return beyond_mm / wall_mm;
}

// Removes the worst spur of every node; false where there is none.
bool remove_worst_spurs(VesselGraph& graph, double spur_radii, double shortest_mm) {
    const auto at_node = links_of_nodes(graph);
    std::vector<std::uint8_t> removed(graph.links.size(), 0);
    bool any = false;
    for (const std::vector<int>& ids : at_node) {
        if (ids.size() < 3) continue;
        int worst = -1;
        double least = std::numeric_limits<double>::infinity();
        for (const int id : ids) {
            const double reach = reach_in_radii(graph, at_node, id, shortest_mm, spur_radii);
            if (reach < least) {
                least = reach;
                worst = id;
            }
        }
        if (worst < 0) continue;
        removed[worst] = 1;
        any = true;
    }
    remove_links(graph, removed);
    return any;
}

// Rings too small to go around anything: a fold of the skeleton inside one lumen.
bool remove_small_rings(VesselGraph& graph) {
    std::vector<std::uint8_t> removed(graph.links.size(), 0);
    const auto at_node = links_of_nodes(graph);
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        const VesselLink& link = graph.links[i];
        removed[i] = link.from == link.to && at_node[link.from].size() > 2 &&
                     length_mm(link) < 4.0 * graph.nodes[link.from].radius_mm;
    }
    remove_links(graph, removed);
    return std::ranges::count(removed, 1) > 0;
}

}  // namespace

void prune_spurs(VesselGraph& graph, double spur_radii, double shortest_mm) {
    join_passing_nodes(graph);
    while (remove_small_rings(graph) || remove_worst_spurs(graph, spur_radii, shortest_mm))
        join_passing_nodes(graph);
}

void remove_short_components(VesselGraph& graph, double shortest_mm) {
    const std::vector<int> component = component_of_nodes(graph);
    if (component.empty()) return;
    std::vector<double> length(*std::ranges::max_element(component) + 1, 0.0);
    for (const VesselLink& link : graph.links) length[component[link.from]] += length_mm(link);
    const auto longest = std::ranges::max_element(length) - length.begin();
    std::vector<std::uint8_t> removed(graph.links.size(), 0);
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        const int c = component[graph.links[i].from];
        removed[i] = c != longest && length[c] < shortest_mm;
    }
    remove_links(graph, removed);
    join_passing_nodes(graph);
}

}  // namespace hepatica
