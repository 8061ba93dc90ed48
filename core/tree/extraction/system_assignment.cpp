// SPDX-License-Identifier: GPL-3.0-or-later
// Labels links by the mask, and floods unknown links from known ones with a priority queue on
// width.
#include "core/tree/extraction/system_assignment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <queue>
#include <tuple>

#include "core/tree/extraction/centreline.h"

namespace hepatica {

namespace {

constexpr VascularSystem unknown = VascularSystem::unknown;

double narrowest_mm(const VesselLink& link) {
    return std::ranges::min(link.radii_mm);
}

// Spreads the known systems over the unknown links, the widest first.
void flood(VesselGraph& graph) {
    const auto at_node = links_of_nodes(graph);
    std::vector<VascularSystem> node_system(graph.nodes.size(), unknown);
    using Open = std::tuple<double, int, VascularSystem>;  // width, -link, system
    std::priority_queue<Open> open;
    const auto reach = [&](int node, VascularSystem system) {
        if (node_system[node] != unknown) return;
        node_system[node] = system;
        for (const int id : at_node[node])
            if (graph.links[id].system == unknown)
                open.emplace(narrowest_mm(graph.links[id]), -id, system);
    };
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        const VesselLink& link = graph.links[i];
        if (link.system == unknown) continue;
        reach(link.from, link.system);
        reach(link.to, link.system);
    }
    while (!open.empty()) {
        const auto [width, negative_id, system] = open.top();
        open.pop();
        VesselLink& link = graph.links[-negative_id];
        if (link.system != unknown) continue;
        const VascularSystem one = node_system[link.from], other = node_system[link.to];
        if (one != unknown && other != unknown && one != other) {
            // Two systems meet in this link. They are separated at its narrowest point, so the link
            // belongs to the system at the end farther from that point.
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

// System number at each point of a link; 0 outside vessels.
std::vector<int> labels_along(const VesselLink& link, const Mask& labels) {
    std::vector<int> found;
    for (const Vec3& p : link.points_mm) found.push_back(value_at(labels, p));
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

VascularSystem system_of_label(int label) {
    return system_numbered(label).value_or(VascularSystem::unknown);
}

// Index that best splits a link into two stretches of one label each, the first of several; none
// where a stretch would be too short to be more than the edge of the other.
std::optional<std::size_t> label_change(const std::vector<int>& values) {
    constexpr std::size_t least_points = 4;
    std::optional<std::size_t> best;
    std::size_t most_right = 0;
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

double share_of(const std::vector<int>& values, VascularSystem system) {
    if (system == unknown) return 0.0;
    return static_cast<double>(std::ranges::count(values, number_of(system))) /
           static_cast<double>(values.size());
}

// Sets a link's system and confidence from the values before `end`.
void decide(VesselLink& link, const std::vector<int>& values, std::size_t end) {
    const std::vector<int> part(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(end));
    link.system = system_of_label(most_frequent(part));
    link.system_confidence = share_of(part, link.system);
}

}  // namespace

void assign_systems(VesselGraph& graph, const Mask& systems) {
    for (std::size_t id = 0; id < graph.links.size(); ++id) {  // grows while links are split
        const std::vector<int> values = labels_along(graph.links[id], systems);
        const std::optional<std::size_t> cut = label_change(values);
        if (cut) {
            const double at_mm = arclengths_mm(graph.links[id].points_mm)[*cut];
            split_link(graph, static_cast<int>(id), at_mm, 0.0);
        }
        decide(graph.links[id], values, cut.value_or(values.size()));
    }
    flood(graph);
    join_passing_nodes(graph);  // parts of one system
}

}  // namespace hepatica
