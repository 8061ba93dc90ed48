// SPDX-License-Identifier: GPL-3.0-or-later
// Makes nodes of ends and junction clusters and traces the runs of voxels between them.
#include "core/tree/extraction/skeleton_graph.h"

#include <algorithm>
#include <map>

#include "core/skeleton/padded_object.h"
#include "core/skeleton/simple_point.h"
#include "core/tree/extraction/inscribed_radius.h"

namespace hepatica {

namespace {

class Tracer {
  public:
    Tracer(const Mask& skeleton, const Mask& vessels)
        : grid_(skeleton.grid), object_(skeleton), radius_(vessels) {}

    VesselGraph trace() {
        if (object_.empty()) return {};
        steps_ = object_.neighbour_steps();
        const std::vector<std::size_t> voxels = object_.object_voxels();
        for (const std::size_t p : voxels) make_node(p);
        for (const std::size_t p : voxels)
            if (const auto node = node_of_.find(p); node != node_of_.end())
                trace_from(p, node->second);
        for (const std::size_t p : voxels)
            if (degree_of(p) == 2 && !object_.marked(p)) trace_ring(p);
        return std::move(graph_);
    }

  private:
    int degree_of(std::size_t p) const { return degree(object_.neighbourhood(p)); }
    Vec3 place(std::size_t p) const {
        const auto [x, y, z] = object_.index_in_mask(p);
        return grid_.to_mm(x, y, z);
    }
    double radius_mm(std::size_t p) { return radius_.at(object_.index_in_mask(p)); }

    std::vector<std::size_t> neighbours(std::size_t p) const {
        std::vector<std::size_t> found;
        for (const std::ptrdiff_t step : steps_)
            if (object_.contains(p + step)) found.push_back(p + step);
        return found;
    }

    // An end is a node; connected voxels of higher degree are one node.
    void make_node(std::size_t p) {
        const int d = degree_of(p);
        if (d == 0 || d == 2 || node_of_.contains(p)) return;
        const int node = static_cast<int>(graph_.nodes.size());
        std::vector<std::size_t> cluster{p};
        node_of_[p] = node;
        for (std::size_t i = 0; d > 2 && i < cluster.size(); ++i)
            for (const std::size_t q : neighbours(cluster[i]))
                if (degree_of(q) > 2 && node_of_.try_emplace(q, node).second) cluster.push_back(q);
        VesselNode made;
        for (const std::size_t q : cluster) {
            made.position_mm += place(q) / static_cast<double>(cluster.size());
            made.radius_mm = std::max(made.radius_mm, radius_mm(q));
        }
        graph_.nodes.push_back(made);
    }

    void trace_from(std::size_t start, int node) {
        for (std::size_t q : neighbours(start)) {
            if (const auto other = node_of_.find(q); other != node_of_.end()) {
                // Two adjacent nodes: one of them is an end.
                if (other->second > node) add_link(node, {}, other->second);
                continue;
            }
            if (object_.marked(q)) continue;
            std::vector<std::size_t> path;
            for (std::size_t before = start; !node_of_.contains(q);) {
                object_.mark(q);
                path.push_back(q);
                const std::vector<std::size_t> two = neighbours(q);
                const std::size_t next = two[0] == before ? two[1] : two[0];
                before = q;
                q = next;
            }
            add_link(node, path, node_of_[q]);
        }
    }

    // A ring without junctions; its first voxel becomes its node.
    void trace_ring(std::size_t start) {
        std::vector<std::size_t> path;
        std::size_t before = start;
        std::size_t p = neighbours(start)[0];
        object_.mark(start);
        while (p != start) {
            object_.mark(p);
            path.push_back(p);
            const std::vector<std::size_t> two = neighbours(p);
            const std::size_t next = two[0] == before ? two[1] : two[0];
            before = p;
            p = next;
        }
        graph_.nodes.push_back({place(start), radius_mm(start)});
        const int node = static_cast<int>(graph_.nodes.size()) - 1;
        add_link(node, path, node);
    }

    void add_link(int from, const std::vector<std::size_t>& path, int to) {
        VesselLink link;
        link.from = from;
        link.to = to;
        const auto add = [&](const Vec3& point, double radius) {
            if (!link.points_mm.empty() && link.points_mm.back() == point) return;
            link.points_mm.push_back(point);
            link.radii_mm.push_back(radius);
        };
        add(graph_.nodes[from].position_mm, graph_.nodes[from].radius_mm);
        for (const std::size_t p : path) add(place(p), radius_mm(p));
        add(graph_.nodes[to].position_mm, graph_.nodes[to].radius_mm);
        graph_.links.push_back(std::move(link));
    }

    Grid grid_;
    PaddedObject object_;
    InscribedRadius radius_;
    std::array<std::ptrdiff_t, 26> steps_{};
    std::map<std::size_t, int> node_of_;
    VesselGraph graph_;
};

}  // namespace

VesselGraph skeleton_graph(const Mask& skeleton, const Mask& vessels) {
    return Tracer(skeleton, vessels).trace();
}

}  // namespace hepatica
