// SPDX-License-Identifier: GPL-3.0-or-later
// Extends the trunk to its entry, finds its division, and shortens it.
#include "core/tree/systems/portal_trunk.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/base/median.h"
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

// Removes a wide free end of the trunk beside the entry. It is where the mask ends, not a branch,
// and most of the inflow would leave through it. Of two such ends the longer one is the vessel.
void remove_stump(VesselGraph& graph, int fork, double radius_mm) {
    constexpr double least_share_of_radius = 0.5;  // a thinner end is a branch
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

// The segments from the root of a segment's tree to the segment itself.
std::vector<int> way_to(const VesselTree& tree, int segment) {
    std::vector<int> way;
    for (int at = segment; at >= 0; at = tree.segments[at].parent) way.push_back(at);
    std::ranges::reverse(way);
    return way;
}

// Where a trunk is cut; everything before that on the way is removed.
struct Cut {
    std::size_t on_way = 0;  // index on the way of the segment that is cut
    double along_mm = 0.0;   // from its beginning
};

Cut cut_before_end(const VesselTree& tree, const std::vector<int>& way) {
    double left_mm = median(tree.segments[way.back()].radii_mm);
    for (std::size_t k = way.size(); k-- > 0;) {
        const double length = length_mm(tree.segments[way[k]]);
        if (length >= left_mm) return {k, length - left_mm};
        left_mm -= length;
    }
    return {};
}

// Marks the segments that a cut removes: those before it on the way, and those attached to them.
std::vector<std::uint8_t> gone_before(const VesselTree& tree, const std::vector<int>& way,
                                      const Cut& cut) {
    std::vector<std::uint8_t> on_way(tree.segments.size(), 0), gone = on_way;
    for (const int id : way) on_way[id] = 1;
    for (std::size_t k = 0; k < cut.on_way; ++k) gone[way[k]] = 1;
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
        const int parent = tree.segments[i].parent;
        if (parent >= 0 && gone[parent] != 0 && on_way[i] == 0) gone[i] = 1;
    }
    return gone;
}

RemovedPieces beside_trunk(const VesselTree& tree, const std::vector<int>& way,
                           const std::vector<std::uint8_t>& gone) {
    RemovedPieces beside;
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
        if (gone[i] == 0 || std::ranges::count(way, static_cast<int>(i)) > 0) continue;
        beside.length_mm += length_mm(tree.segments[i]);
        beside.count += std::ranges::count(way, tree.segments[i].parent) > 0;
    }
    return beside;
}

bool holds_seed(const VesselTree& tree, const std::vector<std::uint8_t>& gone, int cut_segment,
                const Cut& cut, const std::vector<VesselSeed>& seeds) {
    return std::ranges::any_of(seeds, [&](const VesselSeed& seed) {
        const TreePoint at = nearest_point(tree, seed.position_mm);
        return gone[at.segment] != 0 ||
               (at.segment == cut_segment && at.arclength_mm < cut.along_mm);
    });
}

}  // namespace

void lead_trunk_to(const Vec3& entry_mm, VesselGraph& graph) {
    const std::optional<Place> place = nearest_portal_point(entry_mm, graph);
    if (!place) return;
    const VesselLink near = graph.links[place->link];
    const double radius_mm = near.radii_mm[place->point];
    VesselGraph led = graph;
    const int fork =
        split_link(led, place->link, arclengths_mm(near.points_mm)[place->point], step_mm);
    const Vec3 from_mm = led.nodes[fork].position_mm;
    const int steps = static_cast<int>(std::floor((entry_mm - from_mm).norm() / step_mm));
    if (steps < 1) return;  // a portal vein is there already
    graph = std::move(led);
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

int end_of_portal_trunk(const VesselTree& tree) {
    constexpr double notable_share = 1.0 / 7.0;
    std::vector<double> beyond_mm(tree.segments.size(), 0.0);
    std::vector<std::vector<int>> below(tree.segments.size());
    int at = -1;
    for (std::size_t i = tree.segments.size(); i-- > 0;) {  // children before parents
        const VesselSegment& segment = tree.segments[i];
        if (segment.system != VascularSystem::portal || segment.closes_loop) continue;
        const int parent = segment.parent;
        beyond_mm[i] += length_mm(segment);
        const bool goes_on = parent >= 0 && !tree.segments[parent].closes_loop &&
                             tree.segments[parent].system == VascularSystem::portal;
        if (goes_on) {
            beyond_mm[parent] += beyond_mm[i];
            below[parent].push_back(static_cast<int>(i));
        } else if (at < 0 || beyond_mm[i] >= beyond_mm[at]) {
            at = static_cast<int>(i);
        }
    }
    const double least_mm = notable_share * beyond_mm[at];
    while (true) {
        std::vector<int>& next = below[at];
        std::ranges::stable_sort(next, std::ranges::greater{},
                                 [&](int branch) { return beyond_mm[branch]; });
        if (next.empty() || (next.size() > 1 && beyond_mm[next[1]] >= least_mm)) return at;
        at = next.front();
    }
}

std::optional<ShortTrunk> short_trunk(const VesselTree& tree, const Vec3& entry_mm,
                                      const std::vector<VesselSeed>& seeds) {
    if (std::ranges::none_of(tree.segments, [](const VesselSegment& segment) {
            return segment.system == VascularSystem::portal;
        }))
        return std::nullopt;
    const std::vector<int> way = way_to(tree, end_of_portal_trunk(tree));
    const VesselNode& root = tree.nodes[tree.segments[way.front()].proximal_node];
    const Cut cut = cut_before_end(tree, way);
    const bool divides = node_degrees(tree)[tree.segments[way.back()].distal_node] > 2;
    if (!divides || (root.position_mm - entry_mm).norm() >= trunk_reach_mm ||
        (cut.on_way == 0 && cut.along_mm < step_mm))
        return std::nullopt;
    std::vector<std::uint8_t> gone = gone_before(tree, way, cut);
    const int segment = way[cut.on_way];
    if (holds_seed(tree, gone, segment, cut, seeds)) return std::nullopt;
    ShortTrunk made{to_graph(tree), {}, beside_trunk(tree, way, gone), {}};
    int begin = made.graph.links[segment].from;
    if (cut.along_mm >= step_mm) {
        begin = split_link(made.graph, segment, cut.along_mm, 0.0);
        gone[segment] = 1;  // its first half; the second half is a new link
        gone.push_back(0);
    }
    made.begins_mm = made.graph.nodes[begin].position_mm;
    for (std::size_t i = 0; i < gone.size(); ++i)
        if (const VesselLink& link = made.graph.links[i]; gone[i] != 0)
            for (const Vec3& point : link.points_mm) made.left_out.push_back({point, link.system});
    remove_links(made.graph, gone);
    join_passing_nodes(made.graph);
    return made;
}

}  // namespace hepatica
