// SPDX-License-Identifier: GPL-3.0-or-later
// Rebuilds the links of a graph from runs of pieces of one system.
#include "core/tree/systems/labelled_graph.h"

#include <algorithm>
#include <optional>
#include <set>

namespace hepatica {

namespace {

class Rebuilder {
  public:
    Rebuilder(const VesselGraph& graph, const PieceGraph& pieces,
              const std::vector<PieceSystem>& systems)
        : graph_(graph), pieces_(pieces), systems_(systems) {
        out_.nodes = graph.nodes;
    }

    VesselGraph rebuild() {
        for (std::size_t first = 0; first < pieces_.pieces.size();) first = add_link_from(first);
        add_links_within_forks();
        separate_systems(out_);
        join_passing_nodes(out_);
        return std::move(out_);
    }

  private:
    // Adds all runs of one link; returns the first piece of the next link.
    std::size_t add_link_from(std::size_t first) {
        const int id = pieces_.pieces[first].link;
        int from = graph_.links[id].from;
        std::size_t end = first;
        while (end < pieces_.pieces.size() && pieces_.pieces[end].link == id) {
            std::size_t last = end;
            while (last + 1 < pieces_.pieces.size() && pieces_.pieces[last + 1].link == id &&
                   systems_[last + 1].system == systems_[end].system)
                ++last;
            const bool to_the_end =
                last + 1 == pieces_.pieces.size() || pieces_.pieces[last + 1].link != id;
            const int to = to_the_end ? graph_.links[id].to : node_at(id, last);
            add_run(end, last, from, to);
            from = to;
            end = last + 1;
        }
        return end;
    }

    int node_at(int id, std::size_t piece) {
        const int point = pieces_.pieces[piece].last_point;
        out_.nodes.push_back({graph_.links[id].points_mm[point], graph_.links[id].radii_mm[point]});
        return static_cast<int>(out_.nodes.size()) - 1;
    }

    void add_run(std::size_t first, std::size_t last, int from, int to) {
        const VesselPiece &begin = pieces_.pieces[first], &end = pieces_.pieces[last];
        const VesselLink& whole = graph_.links[begin.link];
        VesselLink link;
        link.from = from;
        link.to = to;
        link.system = systems_[first].system;
        double sum = 0.0, length = 0.0;
        for (std::size_t i = first; i <= last; ++i) {
            sum += systems_[i].confidence * pieces_.pieces[i].length_mm;
            length += pieces_.pieces[i].length_mm;
        }
        link.system_confidence = length > 0.0 ? std::min(1.0, sum / length) : 0.0;
        link.points_mm.assign(whole.points_mm.begin() + begin.first_point,
                              whole.points_mm.begin() + end.last_point + 1);
        link.radii_mm.assign(whole.radii_mm.begin() + begin.first_point,
                             whole.radii_mm.begin() + end.last_point + 1);
        out_.links.push_back(std::move(link));
    }

    // Copies links within forks for every system, without those that lead nowhere.
    void add_links_within_forks() {
        std::set<int> within;  // links of the old graph
        for (std::size_t i = 0; i < graph_.links.size(); ++i)
            if (pieces_.within_fork[i] != 0) within.insert(static_cast<int>(i));
        std::set<VascularSystem> systems;
        for (const VesselLink& link : out_.links) systems.insert(link.system);
        for (const VascularSystem system : systems) {
            std::set<int> needed = within;
            prune_dangling(system, needed);
            for (const int id : needed) {
                VesselLink link = graph_.links[id];
                link.system = system;
                link.system_confidence = least_confidence_at(link, system);
                out_.links.push_back(std::move(link));
            }
        }
    }

    // The least confidence of the system's links at the link's nodes.
    double least_confidence_at(const VesselLink& link, VascularSystem system) const {
        std::optional<double> least;
        for (const VesselLink& other : out_.links)
            if (other.system == system && (other.from == link.from || other.from == link.to ||
                                           other.to == link.from || other.to == link.to))
                least = std::min(least.value_or(1.0), other.system_confidence);
        return least.value_or(0.0);
    }

    void prune_dangling(VascularSystem system, std::set<int>& links) const {
        std::vector<int> degree(graph_.nodes.size(), 0);
        for (const VesselLink& link : out_.links)
            if (link.system == system)
                for (const int node : {link.from, link.to})
                    if (node < std::ssize(degree)) ++degree[node];
        for (const int id : links) ++degree[graph_.links[id].from], ++degree[graph_.links[id].to];
        for (bool changed = true; changed;) {
            changed = std::erase_if(links, [&](int id) {
                          const VesselLink& link = graph_.links[id];
                          if (degree[link.from] > 1 && degree[link.to] > 1) return false;
                          --degree[link.from], --degree[link.to];
                          return true;
                      }) > 0;
        }
    }

    const VesselGraph& graph_;
    const PieceGraph& pieces_;
    const std::vector<PieceSystem>& systems_;
    VesselGraph out_;
};

}  // namespace

VesselGraph labelled_graph(const VesselGraph& graph, const PieceGraph& pieces,
                           const std::vector<PieceSystem>& systems) {
    return Rebuilder(graph, pieces, systems).rebuild();
}

}  // namespace hepatica
