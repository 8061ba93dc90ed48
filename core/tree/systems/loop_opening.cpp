// SPDX-License-Identifier: GPL-3.0-or-later
// Detaches each loop-closing segment at one of its ends.
#include "core/tree/systems/loop_opening.h"

#include <algorithm>
#include <cmath>

#include "core/tree/extraction/centreline.h"
#include "core/tree/extraction/cut_gap.h"

namespace hepatica {

namespace {

constexpr double direction_reach_mm = 5.0;  // length over which a direction is measured

// Direction of a link away from one of its nodes.
Vec3 direction_from(const VesselLink& link, int node) {
    VesselLink turned = link;
    if (link.from != node) reverse(turned);
    const std::vector<double> along = arclengths_mm(turned.points_mm);
    const auto last = std::min<std::ptrdiff_t>(
        std::ranges::lower_bound(along, direction_reach_mm) - along.begin(), std::ssize(along) - 1);
    return (turned.points_mm[last] - turned.points_mm.front()).normalized();
}

// Cosine of the straightest continuation of a link through a node: 1 is straight on.
double straightest(const VesselGraph& graph, const std::vector<std::vector<int>>& at_node, int id,
                   int node) {
    double best = -1.0;
    const Vec3 own = direction_from(graph.links[id], node);
    for (const int other : at_node[node])
        if (other != id) best = std::max(best, -own.dot(direction_from(graph.links[other], node)));
    return best;
}

// Shortens the link at its end `to` until it is clear of the node's lumen; false where too little
// would be left.
bool detach_end(VesselGraph& graph, VesselLink& link) {
    const std::vector<double> along = arclengths_mm(link.points_mm);
    const VesselNode& node = graph.nodes[link.to];
    std::size_t kept = link.points_mm.size();
    while (kept > 1 && (link.points_mm[kept - 1] - node.position_mm).norm() <
                           node.radius_mm + link.radii_mm[kept - 1] + cut_gap_mm)
        --kept;
    if (kept < 2 || along[kept - 1] < 2.0 * link.radii_mm[kept / 2]) return false;
    link.points_mm.resize(kept);
    link.radii_mm.resize(kept);
    link.to = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({link.points_mm.back(), link.radii_mm.back()});
    return true;
}

}  // namespace

OpenedLoops open_loops(const VesselTree& tree) {
    OpenedLoops opened{to_graph(tree)};
    VesselGraph& graph = opened.graph;
    std::vector<std::uint8_t> removed(graph.links.size(), 0);
    auto at_node = links_of_nodes(graph);  // without ends that are detached
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
        if (!tree.segments[i].closes_loop) continue;
        ++opened.count;
        VesselLink& link = graph.links[i];
        const auto id = static_cast<int>(i);
        if (straightest(graph, at_node, id, link.from) < straightest(graph, at_node, id, link.to))
            reverse(link);
        std::erase(at_node[link.to], id);
        if (detach_end(graph, link)) continue;
        std::erase(at_node[link.from], id);
        removed[i] = 1;
    }
    remove_links(graph, removed);
    join_passing_nodes(graph);
    return opened;
}

}  // namespace hepatica
