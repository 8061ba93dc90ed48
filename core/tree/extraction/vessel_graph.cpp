// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the operations on vessel graphs; directed() is in directed_forest.cpp.
#include "core/tree/extraction/vessel_graph.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/tree/extraction/centreline.h"

namespace hepatica {

namespace {

void append_reversed(VesselLink& link, const VesselLink& other) {
    link.points_mm.insert(link.points_mm.end(), other.points_mm.rbegin() + 1,
                          other.points_mm.rend());
    link.radii_mm.insert(link.radii_mm.end(), other.radii_mm.rbegin() + 1, other.radii_mm.rend());
}

void append(VesselLink& link, const VesselLink& other) {
    link.points_mm.insert(link.points_mm.end(), other.points_mm.begin() + 1, other.points_mm.end());
    link.radii_mm.insert(link.radii_mm.end(), other.radii_mm.begin() + 1, other.radii_mm.end());
}

double joint_confidence(const VesselLink& a, const VesselLink& b) {
    const double a_mm = length_mm(a), b_mm = length_mm(b);
    if (!(a_mm + b_mm > 0.0)) return a.system_confidence;
    return (a_mm * a.system_confidence + b_mm * b.system_confidence) / (a_mm + b_mm);
}

void remove_repeated_points(VesselLink& link) {
    for (std::size_t i = 1; i < link.points_mm.size();) {
        if (link.points_mm.size() == 2 || link.points_mm[i] != link.points_mm[i - 1]) {
            ++i;
            continue;
        }
        link.points_mm.erase(link.points_mm.begin() + static_cast<std::ptrdiff_t>(i));
        link.radii_mm.erase(link.radii_mm.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

void drop_unused_nodes(VesselGraph& graph) {
    std::vector<int> new_id(graph.nodes.size(), -1);
    for (const VesselLink& link : graph.links) new_id[link.from] = new_id[link.to] = 0;
    std::vector<VesselNode> kept;
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
        if (new_id[n] < 0) continue;
        new_id[n] = static_cast<int>(kept.size());
        kept.push_back(graph.nodes[n]);
    }
    graph.nodes = std::move(kept);
    for (VesselLink& link : graph.links) {
        link.from = new_id[link.from];
        link.to = new_id[link.to];
    }
}

}  // namespace

void reverse(VesselLink& link) {
    std::swap(link.from, link.to);
    std::ranges::reverse(link.points_mm);
    std::ranges::reverse(link.radii_mm);
}

double length_mm(const VesselLink& link) {
    double length = 0.0;
    for (std::size_t i = 1; i < link.points_mm.size(); ++i)
        length += (link.points_mm[i] - link.points_mm[i - 1]).norm();
    return length;
}

std::vector<std::vector<int>> links_of_nodes(const VesselGraph& graph) {
    std::vector<std::vector<int>> ids(graph.nodes.size());
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        ids[graph.links[i].from].push_back(static_cast<int>(i));
        ids[graph.links[i].to].push_back(static_cast<int>(i));
    }
    return ids;
}

void remove_links(VesselGraph& graph, const std::vector<std::uint8_t>& removed) {
    std::vector<VesselLink> kept;
    for (std::size_t i = 0; i < graph.links.size(); ++i)
        if (removed[i] == 0) kept.push_back(std::move(graph.links[i]));
    graph.links = std::move(kept);
}

void join_passing_nodes(VesselGraph& graph) {
    std::vector<std::vector<int>> at_node = links_of_nodes(graph);
    std::vector<std::uint8_t> gone(graph.links.size(), 0);
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
        const int node = static_cast<int>(n);
        if (at_node[n].size() != 2 || at_node[n][0] == at_node[n][1]) continue;
        VesselLink& first = graph.links[at_node[n][0]];
        VesselLink& second = graph.links[at_node[n][1]];
        if (first.system != second.system) continue;
        first.system_confidence = joint_confidence(first, second);
        if (first.from == node) reverse(first);
        if (second.to == node)
            append_reversed(first, second);
        else
            append(first, second);
        first.to = second.to == node ? second.from : second.to;
        std::ranges::replace(at_node[first.to], at_node[n][1], at_node[n][0]);
        gone[at_node[n][1]] = 1;
        at_node[n].clear();
    }
    remove_links(graph, gone);
    drop_unused_nodes(graph);
}

SystemNodes separate_systems(VesselGraph& graph) {
    SystemNodes node_of;
    std::vector<std::uint8_t> has_owner(graph.nodes.size(), 0);
    const auto own = [&](int node, VascularSystem system) {
        const auto [entry, is_new] = node_of.try_emplace({node, system}, node);
        if (!is_new) return entry->second;
        if (has_owner[node] == 0) {
            has_owner[node] = 1;
        } else {
            graph.nodes.push_back(VesselNode(graph.nodes[node]));
            entry->second = static_cast<int>(graph.nodes.size()) - 1;
        }
        return entry->second;
    };
    for (VesselLink& link : graph.links) {
        link.from = own(link.from, link.system);
        link.to = own(link.to, link.system);
    }
    return node_of;
}

std::vector<int> component_of_nodes(const VesselGraph& graph) {
    std::vector<int> component(graph.nodes.size(), -1);
    const auto at_node = links_of_nodes(graph);
    int count = 0;
    for (std::size_t start = 0; start < graph.nodes.size(); ++start) {
        if (component[start] >= 0) continue;
        std::vector<int> open{static_cast<int>(start)};
        component[start] = count;
        while (!open.empty()) {
            const int n = open.back();
            open.pop_back();
            for (const int id : at_node[n])
                for (const int other : {graph.links[id].from, graph.links[id].to})
                    if (component[other] < 0) {
                        component[other] = count;
                        open.push_back(other);
                    }
        }
        ++count;
    }
    return component;
}

VesselGraph to_graph(const VesselTree& tree) {
    VesselGraph graph;
    graph.nodes = tree.nodes;
    for (const VesselSegment& s : tree.segments)
        graph.links.push_back({s.proximal_node, s.distal_node, s.system, s.system_confidence,
                               s.points_mm, s.radii_mm});
    return graph;
}

std::vector<VesselSegment> segments_of(const VesselGraph& graph) {
    std::vector<VesselSegment> segments;
    for (const VesselLink& link : graph.links) {
        VesselSegment& segment = segments.emplace_back();
        segment.points_mm = link.points_mm;
        segment.radii_mm = link.radii_mm;
    }
    return segments;
}

std::vector<RootWish> root_wishes(const VesselTree& tree) {
    std::vector<RootWish> wishes;
    for (const int id : roots(tree))
        wishes.push_back({tree.segments[id].proximal_node, tree.segments[id].system});
    return wishes;
}

int split_link(VesselGraph& graph, int id, double along_mm, double snap_mm) {
    VesselLink& link = graph.links[id];
    const std::vector<double> at_mm = arclengths_mm(link.points_mm);
    if (along_mm <= snap_mm && along_mm <= at_mm.back() - along_mm) return link.from;
    if (at_mm.back() - along_mm <= snap_mm) return link.to;
    std::size_t i = 1;
    while (i + 1 < at_mm.size() && at_mm[i] <= along_mm) ++i;
    const double share =
        std::clamp((along_mm - at_mm[i - 1]) / (at_mm[i] - at_mm[i - 1]), 0.0, 1.0);
    const Vec3 place = link.points_mm[i - 1] + share * (link.points_mm[i] - link.points_mm[i - 1]);
    const double radius = link.radii_mm[i - 1] + share * (link.radii_mm[i] - link.radii_mm[i - 1]);
    const int node = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({place, radius});

    VesselLink second{node, link.to, link.system, link.system_confidence, {place}, {radius}};
    const auto split = static_cast<std::ptrdiff_t>(i);
    second.points_mm.insert(second.points_mm.end(), link.points_mm.begin() + split,
                            link.points_mm.end());
    second.radii_mm.insert(second.radii_mm.end(), link.radii_mm.begin() + split,
                           link.radii_mm.end());
    link.to = node;
    link.points_mm.resize(i);
    link.radii_mm.resize(i);
    link.points_mm.push_back(place);
    link.radii_mm.push_back(radius);
    for (VesselLink* half : {&link, &second}) remove_repeated_points(*half);
    graph.links.push_back(std::move(second));
    return node;
}

}  // namespace hepatica
