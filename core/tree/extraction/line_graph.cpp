// SPDX-License-Identifier: GPL-3.0-or-later
// Merges points and chains edges between nodes into links.
#include "core/tree/extraction/line_graph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace hepatica {

namespace {

constexpr double same_place_mm = 1e-3;

// For each point, the first point at the same position (rounded to a micrometre).
std::vector<int> merged(const std::vector<Vec3>& points_mm) {
    std::map<std::array<long long, 3>, int> first_at;
    std::vector<int> representative(points_mm.size());
    for (std::size_t i = 0; i < points_mm.size(); ++i) {
        std::array<long long, 3> place{};
        for (int a = 0; a < 3; ++a) place[a] = std::llround(points_mm[i][a] / same_place_mm);
        representative[i] = first_at.try_emplace(place, static_cast<int>(i)).first->second;
    }
    return representative;
}

class Chainer {
  public:
    Chainer(const std::vector<Vec3>& points_mm, const std::vector<LineEdge>& edges,
            const std::vector<int>& kept_points)
        : points_mm_(points_mm), representative_(merged(points_mm)), at_point_(points_mm.size()) {
        std::set<std::pair<int, int>> seen;
        for (LineEdge edge : edges) {
            edge.from = representative_[edge.from];
            edge.to = representative_[edge.to];
            if (edge.from == edge.to || !seen.insert(std::minmax(edge.from, edge.to)).second)
                continue;
            at_point_[edge.from].push_back(static_cast<int>(edges_.size()));
            at_point_[edge.to].push_back(static_cast<int>(edges_.size()));
            edges_.push_back(edge);
        }
        used_.assign(edges_.size(), 0);
        node_.assign(points_mm.size(), -1);
        for (const int p : kept_points) make_node(representative_[p]);
    }

    LineGraph chain() {
        for (std::size_t p = 0; p < at_point_.size(); ++p)
            if (!at_point_[p].empty() && !passes(static_cast<int>(p)))
                make_node(static_cast<int>(p));
        for (std::size_t p = 0; p < at_point_.size(); ++p)
            if (node_[p] >= 0)
                for (const int edge : at_point_[p]) follow(static_cast<int>(p), edge);
        for (std::size_t e = 0; e < edges_.size(); ++e) {  // rings without a node
            if (used_[e] != 0) continue;
            make_node(edges_[e].from);
            follow(edges_[e].from, static_cast<int>(e));
        }
        for (std::size_t p = 0; p < node_.size(); ++p) node_[p] = node_[representative_[p]];
        return {std::move(graph_), std::move(node_)};
    }

  private:
    bool passes(int p) const {
        return at_point_[p].size() == 2 &&
               edges_[at_point_[p][0]].system == edges_[at_point_[p][1]].system;
    }

    void make_node(int p) {
        if (node_[p] >= 0) return;
        double radius = 0.0;
        for (const int e : at_point_[p]) radius = std::max(radius, radius_at(e, p));
        node_[p] = static_cast<int>(graph_.nodes.size());
        graph_.nodes.push_back({points_mm_[p], radius});
    }

    double radius_at(int edge, int p) const {
        return edges_[edge].from == p ? edges_[edge].from_radius_mm : edges_[edge].to_radius_mm;
    }

    void follow(int start, int edge) {
        if (used_[edge] != 0) return;
        VesselLink link;
        link.system = edges_[edge].system;
        link.from = node_[start];
        link.points_mm.push_back(points_mm_[start]);
        link.radii_mm.push_back(radius_at(edge, start));
        for (int p = start;;) {
            used_[edge] = 1;
            p = edges_[edge].from == p ? edges_[edge].to : edges_[edge].from;
            link.points_mm.push_back(points_mm_[p]);
            link.radii_mm.push_back(radius_at(edge, p));
            if (node_[p] >= 0) {
                link.to = node_[p];
                break;
            }
            edge = at_point_[p][0] == edge ? at_point_[p][1] : at_point_[p][0];
            link.radii_mm.back() = 0.5 * (link.radii_mm.back() + radius_at(edge, p));
        }
        graph_.links.push_back(std::move(link));
    }

    const std::vector<Vec3>& points_mm_;
    std::vector<int> representative_;
    std::vector<LineEdge> edges_;
    std::vector<std::vector<int>> at_point_;
    std::vector<std::uint8_t> used_;
    std::vector<int> node_;
    VesselGraph graph_;
};

}  // namespace

LineGraph graph_of_edges(const std::vector<Vec3>& points_mm, const std::vector<LineEdge>& edges,
                         const std::vector<int>& kept_points) {
    return Chainer(points_mm, edges, kept_points).chain();
}

}  // namespace hepatica
