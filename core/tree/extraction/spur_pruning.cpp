// SPDX-License-Identifier: GPL-3.0-or-later
// Alternates the removal of spurs and small rings with joining links, until nothing changes.
#include "core/tree/extraction/spur_pruning.h"

#include <algorithm>
#include <limits>

namespace hepatica {

namespace {

// Number of the parent's radii that an end link reaches beyond the parent's wall; infinite for
// links that are no end links or long enough to be vessels.
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

// Removes rings too small to enclose anything: folds of the skeleton inside one lumen.
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

}  // namespace hepatica
