// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/system_assignment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <tuple>

#include "core/tree/extraction/centreline.h"
#include "core/tree/extraction/centreline_locator.h"

namespace hepatica {

namespace {

constexpr int nobody = std::numeric_limits<int>::min();

// The graph's links as the segments of a tree, for those that look things up in trees.
VesselTree as_segments(const VesselGraph& graph, bool with_undecided) {
    VesselTree tree;
    for (const VesselLink& link : graph.links) {
        if (!with_undecided && link.system == nobody) continue;
        VesselSegment& segment = tree.segments.emplace_back();
        segment.points_mm = link.points_mm;
        segment.radii_mm = link.radii_mm;
        segment.system = link.system;
    }
    return tree;
}

double narrowest_mm(const VesselLink& link) {
    return std::ranges::min(link.radii_mm);
}

// Parts a link that two seeds of different systems claim at its narrowest point between them.
void split_between(VesselGraph& graph, int id, double a_mm, double b_mm) {
    const VesselLink& link = graph.links[id];
    const std::vector<double> at_mm = arclengths_mm(link.points_mm);
    const auto [low, high] = std::minmax(a_mm, b_mm);
    double narrowest = std::numeric_limits<double>::infinity(), place = 0.5 * (low + high);
    for (std::size_t i = 0; i < at_mm.size(); ++i) {
        if (at_mm[i] < low || at_mm[i] > high || link.radii_mm[i] >= narrowest) continue;
        narrowest = link.radii_mm[i];
        place = at_mm[i];
    }
    split_link(graph, id, place, 0.0);
}

// Links that hold seeds get their system; a link with seeds of two systems is split until each part
// holds seeds of one.
void place_seeds(VesselGraph& graph, const std::vector<SystemSeed>& seeds) {
    for (VesselLink& link : graph.links) link.system = nobody;
    std::vector<TreePoint> placed;
    for (std::size_t s = 0; s < seeds.size(); ++s) {
        TreePoint at = nearest_point(as_segments(graph, true), seeds[s].position_mm);
        for (std::size_t other = 0; other < s; ++other) {
            if (placed[other].segment != at.segment || seeds[other].system == seeds[s].system)
                continue;
            split_between(graph, at.segment, placed[other].arclength_mm, at.arclength_mm);
            const VesselTree parts = as_segments(graph, true);
            for (std::size_t moved = 0; moved < s; ++moved) {
                placed[moved] = nearest_point(parts, seeds[moved].position_mm);
                graph.links[placed[moved].segment].system = seeds[moved].system;
            }
            at = nearest_point(parts, seeds[s].position_mm);
        }
        graph.links[at.segment].system = seeds[s].system;
        placed.push_back(at);
    }
}

// Spreads the systems over the widest links first.
void flood(VesselGraph& graph) {
    const auto at_node = links_of_nodes(graph);
    std::vector<int> node_system(graph.nodes.size(), nobody);
    using Open = std::tuple<double, int, int>;  // width, -link, system
    std::priority_queue<Open> open;
    const auto reach = [&](int node, int system) {
        if (node_system[node] != nobody) return;
        node_system[node] = system;
        for (const int id : at_node[node])
            if (graph.links[id].system == nobody)
                open.emplace(narrowest_mm(graph.links[id]), -id, system);
    };
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        const VesselLink& link = graph.links[i];
        if (link.system == nobody) continue;
        reach(link.from, link.system);
        reach(link.to, link.system);
    }
    while (!open.empty()) {
        const auto [width, negative_id, system] = open.top();
        open.pop();
        VesselLink& link = graph.links[-negative_id];
        if (link.system != nobody) continue;
        const int one = node_system[link.from], other = node_system[link.to];
        if (one != nobody && other != nobody && one != other) {
            // Where two systems meet: the link goes to the side that its narrowest point is not on.
            const auto narrowest = std::ranges::min_element(link.radii_mm) - link.radii_mm.begin();
            const bool near_from = 2 * narrowest < std::ssize(link.radii_mm);
            link.system = near_from ? other : one;
            continue;
        }
        link.system = system;
        reach(link.from, system);
        reach(link.to, system);
    }
}

void join_nearest_system(VesselGraph& graph) {
    const VesselTree known = as_segments(graph, false);
    const CentrelineLocator locator(known);
    const std::vector<int> component = component_of_nodes(graph);
    struct Choice {
        double distance_mm = std::numeric_limits<double>::infinity();
        int system = 0;
    };
    std::vector<Choice> choices(graph.nodes.size());
    for (const VesselLink& link : graph.links) {
        if (link.system != nobody) continue;
        Choice& choice = choices[component[link.from]];
        for (const Vec3& point : link.points_mm) {
            const auto nearest = locator.nearest(point, std::numeric_limits<double>::max());
            if (nearest && nearest->distance_mm < choice.distance_mm)
                choice = {nearest->distance_mm, known.segments[nearest->segment].system};
        }
    }
    for (VesselLink& link : graph.links)
        if (link.system == nobody) link.system = choices[component[link.from]].system;
}

// Value of the mask at each point of a link; 0 where a point lies outside of it.
std::vector<int> labels_along(const VesselLink& link, const Mask& labels) {
    std::vector<int> found;
    for (const Vec3& p : link.points_mm) {
        const Vec3 index = labels.grid.to_index(p);
        const auto x = static_cast<int>(std::lround(index.x()));
        const auto y = static_cast<int>(std::lround(index.y()));
        const auto z = static_cast<int>(std::lround(index.z()));
        found.push_back(labels.grid.contains(x, y, z) ? labels.at(x, y, z) : 0);
    }
    return found;
}

int most_frequent(const std::vector<int>& values) {
    std::map<int, int> counts;
    for (const int v : values)
        if (v != 0) ++counts[v];
    int best = 0;
    for (const auto& [value, count] : counts)
        if (best == 0 || count > counts[best]) best = value;
    return best;
}

// Index at which a link parts best into two stretches of one label each; 0 where neither stretch
// would be long enough to be more than the edge of the other.
std::size_t label_change(const std::vector<int>& values) {
    constexpr std::size_t least_points = 4;
    std::size_t best = 0, most_right = 0;
    for (std::size_t cut = least_points; cut + least_points <= values.size(); ++cut) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(cut);
        const int left = most_frequent({values.begin(), middle});
        const int right = most_frequent({middle, values.end()});
        if (left == right || left == 0 || right == 0) continue;
        const auto hits = static_cast<std::size_t>(std::count(values.begin(), middle, left) +
                                                   std::count(middle, values.end(), right));
        if (hits <= most_right) continue;
        most_right = hits;
        best = cut;
    }
    return best;
}

}  // namespace

bool assign_systems_by_labels(VesselGraph& graph, const Mask& labels) {
    std::set<int> seen;
    for (const VesselLink& link : graph.links)
        for (const int label : labels_along(link, labels))
            if (label != 0) seen.insert(label);
    if (seen.size() < 2) return false;
    for (std::size_t id = 0; id < graph.links.size(); ++id) {  // grows while links are split
        const std::vector<int> values = labels_along(graph.links[id], labels);
        if (const std::size_t cut = label_change(values); cut > 0) {
            const double at_mm = arclengths_mm(graph.links[id].points_mm)[cut];
            split_link(graph, static_cast<int>(id), at_mm, 0.0);
            graph.links[id].system =
                most_frequent({values.begin(), values.begin() + static_cast<std::ptrdiff_t>(cut)});
            continue;
        }
        const int label = most_frequent(values);
        graph.links[id].system = label != 0 ? label : *seen.begin();
    }
    return true;
}

void assign_systems(VesselGraph& graph, const std::vector<SystemSeed>& seeds) {
    if (seeds.empty() || graph.links.empty()) return;
    place_seeds(graph, seeds);
    flood(graph);
    join_nearest_system(graph);
}

}  // namespace hepatica
