// SPDX-License-Identifier: GPL-3.0-or-later
// Implements directed() of vessel_graph.h: from an undirected graph to trees with roots, parents
// and Strahler orders, by Prim's algorithm on the widths of links (a maximum spanning tree).
#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

#include "core/tree/extraction/vessel_graph.h"

namespace hepatica {

namespace {

// Smallest radius of a link, without its end points where there are enough.
double narrowest_mm(const VesselLink& link) {
    const std::size_t n = link.radii_mm.size();
    const std::size_t skip = n >= 5 ? 1 : 0;
    return *std::min_element(link.radii_mm.begin() + skip, link.radii_mm.end() - skip);
}

double mean_radius_mm(const VesselLink& link) {
    double sum = 0.0;
    for (const double r : link.radii_mm) sum += r;
    return sum / static_cast<double>(link.radii_mm.size());
}

// Splits a link from a node to itself in two, and drops it where it has fewer than three points.
void split_rings(VesselGraph& graph) {
    const std::size_t count = graph.links.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (graph.links[i].from != graph.links[i].to || graph.links[i].points_mm.size() < 3)
            continue;
        VesselLink first = graph.links[i];
        VesselLink second = first;
        const auto middle = static_cast<std::ptrdiff_t>(first.points_mm.size() / 2);
        graph.nodes.push_back({first.points_mm[middle], first.radii_mm[middle]});
        first.to = second.from = static_cast<int>(graph.nodes.size()) - 1;
        first.points_mm.resize(middle + 1);
        first.radii_mm.resize(middle + 1);
        second.points_mm.erase(second.points_mm.begin(), second.points_mm.begin() + middle);
        second.radii_mm.erase(second.radii_mm.begin(), second.radii_mm.begin() + middle);
        graph.links[i] = std::move(first);
        graph.links.push_back(std::move(second));
    }
    std::erase_if(graph.links, [](const VesselLink& l) { return l.from == l.to; });
}

// The wishes for the nodes that their systems have now; -1 where a system is not at the node.
void follow_systems(const SystemNodes& node_of, std::vector<RootWish>& wishes) {
    for (RootWish& wish : wishes) {
        const auto own = node_of.find({wish.node, wish.system});
        wish.node = own == node_of.end() ? -1 : own->second;
    }
}

class Director {
  public:
    explicit Director(const VesselGraph& graph)
        : graph_(graph),
          at_node_(links_of_nodes(graph)),
          component_(component_of_nodes(graph)),
          reached_by_(graph.nodes.size(), not_reached),
          used_(graph.links.size(), 0) {}

    VesselTree build(std::span<const RootWish> wishes) {
        for (const int root : chosen_roots(wishes)) grow(root);
        sort_depth_first();
        set_strahler_orders(tree_);
        return std::move(tree_);
    }

  private:
    static constexpr int not_reached = -2;

    // Prefers wide ends. The mean radius of the link counts, because a trunk is wide along its
    // length.
    double root_merit(int node) const {
        double widest = 0.0;
        for (const int id : at_node_[node])
            widest = std::max(widest, mean_radius_mm(graph_.links[id]));
        return at_node_[node].size() == 1 ? widest + 1e6 : widest;
    }

    std::vector<int> chosen_roots(std::span<const RootWish> wishes) const {
        struct Component {
            int root = -1;
            bool wished = false;
            VascularSystem system = VascularSystem::unknown;
            double length_mm = 0.0;
        };
        const int count = component_.empty() ? 0 : *std::ranges::max_element(component_) + 1;
        std::vector<Component> components(count);
        for (const VesselLink& link : graph_.links) {
            components[component_[link.from]].length_mm += length_mm(link);
            components[component_[link.from]].system = link.system;
        }
        for (const RootWish& wish : wishes) {
            if (wish.node < 0) continue;
            Component& c = components[component_[wish.node]];
            if (!c.wished) c.root = wish.node;
            c.wished = true;
        }
        for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
            Component& c = components[component_[n]];
            const int node = static_cast<int>(n);
            if (!c.wished && (c.root < 0 || root_merit(node) > root_merit(c.root))) c.root = node;
        }
        std::ranges::stable_sort(
            components, {}, [](const Component& c) { return std::pair(c.system, -c.length_mm); });
        std::vector<int> found;
        for (const Component& c : components)
            if (c.root >= 0 && !at_node_[c.root].empty()) found.push_back(c.root);
        return found;
    }

    // Prim's spanning tree, widest links first.
    void grow(int root) {
        using Open = std::tuple<double, int, int>;  // width, -link, node it is reached from
        std::priority_queue<Open> open;
        const auto push_links = [&](int node) {
            for (const int id : at_node_[node])
                if (used_[id] == 0) open.emplace(narrowest_mm(graph_.links[id]), -id, node);
        };
        reached_by_[root] = -1;
        push_links(root);
        while (!open.empty()) {
            const auto [width, negative_id, node] = open.top();
            open.pop();
            const int id = -negative_id;
            if (used_[id] != 0) continue;
            used_[id] = 1;
            const VesselLink& link = graph_.links[id];
            const int other = link.from == node ? link.to : link.from;
            const bool closes_loop = reached_by_[other] != not_reached;
            add_segment(link, node, other, closes_loop);
            if (closes_loop) continue;
            reached_by_[other] = static_cast<int>(tree_.segments.size()) - 1;
            push_links(other);
        }
    }

    void add_segment(const VesselLink& link, int proximal, int distal, bool closes_loop) {
        VesselSegment segment;
        segment.proximal_node = proximal;
        segment.distal_node = distal;
        segment.parent = reached_by_[proximal];
        segment.system = link.system;
        segment.system_confidence = link.system_confidence;
        segment.closes_loop = closes_loop;
        segment.points_mm = link.points_mm;
        segment.radii_mm = link.radii_mm;
        if (link.from != proximal) {
            std::ranges::reverse(segment.points_mm);
            std::ranges::reverse(segment.radii_mm);
        }
        tree_.segments.push_back(std::move(segment));
    }

    void sort_depth_first() {
        const auto child_ids = children(tree_);
        std::vector<int> order, stack;
        for (std::size_t i = tree_.segments.size(); i-- > 0;)
            if (tree_.segments[i].parent < 0) stack.push_back(static_cast<int>(i));
        while (!stack.empty()) {
            const int id = stack.back();
            stack.pop_back();
            order.push_back(id);
            stack.insert(stack.end(), child_ids[id].rbegin(), child_ids[id].rend());
        }
        std::vector<int> new_segment(order.size());
        for (std::size_t i = 0; i < order.size(); ++i) new_segment[order[i]] = static_cast<int>(i);
        std::vector<VesselSegment> sorted;
        std::vector<int> new_node(graph_.nodes.size(), -1);
        for (const int id : order) {
            VesselSegment& segment = sorted.emplace_back(std::move(tree_.segments[id]));
            if (segment.parent >= 0) segment.parent = new_segment[segment.parent];
            for (int* node : {&segment.proximal_node, &segment.distal_node}) {
                if (new_node[*node] < 0) {
                    new_node[*node] = static_cast<int>(tree_.nodes.size());
                    tree_.nodes.push_back(graph_.nodes[*node]);
                }
                *node = new_node[*node];
            }
        }
        tree_.segments = std::move(sorted);
    }

    const VesselGraph& graph_;
    std::vector<std::vector<int>> at_node_;
    std::vector<int> component_;
    std::vector<int> reached_by_;  // segment that ends at the node; -1 at a root
    std::vector<std::uint8_t> used_;
    VesselTree tree_;
};

}  // namespace

VesselTree directed(VesselGraph graph, std::span<const RootWish> wishes) {
    std::vector<RootWish> own_wishes(wishes.begin(), wishes.end());
    split_rings(graph);
    follow_systems(separate_systems(graph), own_wishes);
    return Director(graph).build(own_wishes);
}

}  // namespace hepatica
