// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/systems/portal_trunk.h"

#include <cmath>
#include <optional>

#include "core/tree/extraction/centreline.h"

namespace hepatica {

namespace {

constexpr double trunk_reach_mm = 15.0;
constexpr double step_mm = 1.0;

struct Place {
    int link = -1;
    std::size_t point = 0;
};

std::optional<Place> nearest_portal_point(const Vec3& at_mm, const VesselGraph& graph) {
    std::optional<Place> nearest;
    double least_mm = trunk_reach_mm;
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        if (graph.links[i].system != VascularSystem::portal) continue;
        for (std::size_t p = 0; p < graph.links[i].points_mm.size(); ++p) {
            const double away_mm = (graph.links[i].points_mm[p] - at_mm).norm();
            if (away_mm >= least_mm) continue;
            least_mm = away_mm;
            nearest = {static_cast<int>(i), p};
        }
    }
    return nearest;
}

// A free end of the trunk beside the entry is where the mask ends, not a branch: most of what comes
// in at the entry would leave by it at once. Of two such ends the farther one is the vessel.
void remove_stump(VesselGraph& graph, int fork, double radius_mm) {
    constexpr double least_share_of_radius = 0.5;  // a thinner one is a branch
    const std::vector<std::vector<int>> at_node = links_of_nodes(graph);
    int stump = -1;
    double shortest_mm = trunk_reach_mm;
    for (const int id : at_node[static_cast<std::size_t>(fork)]) {
        const VesselLink& link = graph.links[static_cast<std::size_t>(id)];
        const bool ends =
            at_node[static_cast<std::size_t>(link.from == fork ? link.to : link.from)].size() == 1;
        const double tip_mm = link.from == fork ? link.radii_mm.back() : link.radii_mm.front();
        if (!ends || tip_mm < least_share_of_radius * radius_mm || length_mm(link) > shortest_mm)
            continue;
        shortest_mm = length_mm(link);
        stump = id;
    }
    if (stump < 0 || at_node[static_cast<std::size_t>(fork)].size() < 2) return;
    std::vector<std::uint8_t> removed(graph.links.size(), 0);
    removed[static_cast<std::size_t>(stump)] = 1;
    remove_links(graph, removed);
}

}  // namespace

void lead_trunk_to(const Vec3& entry_mm, VesselGraph& graph) {
    const std::optional<Place> place = nearest_portal_point(entry_mm, graph);
    if (!place) return;
    const VesselLink near = graph.links[place->link];
    const double radius_mm = near.radii_mm[place->point];
    const int fork =
        split_link(graph, place->link, arclengths_mm(near.points_mm)[place->point], step_mm);
    const Vec3 from_mm = graph.nodes[fork].position_mm;
    const int steps = static_cast<int>(std::floor((entry_mm - from_mm).norm() / step_mm));
    if (steps < 1) return;
    remove_stump(graph, fork, radius_mm);
    VesselLink trunk;
    trunk.from = fork;
    trunk.to = static_cast<int>(graph.nodes.size());
    trunk.system = VascularSystem::portal;
    trunk.system_confidence = near.system_confidence;
    for (int i = 0; i <= steps; ++i) {
        trunk.points_mm.push_back(from_mm + (entry_mm - from_mm) * i / steps);
        trunk.radii_mm.push_back(radius_mm);
    }
    graph.nodes.push_back({entry_mm, radius_mm});
    graph.links.push_back(std::move(trunk));
    join_passing_nodes(graph);
}

}  // namespace hepatica
