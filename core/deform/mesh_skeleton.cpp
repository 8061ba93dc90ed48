// SPDX-License-Identifier: GPL-3.0-or-later
// The skeleton of a mesh without centrelines: a Reeb graph of the distance along mesh edges.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "core/deform/frame_skeleton.h"

namespace hepatica {

namespace {

struct Graph {
    std::vector<int> begin{0};
    std::vector<int> neighbour;
};

Graph edges_of(const TetMesh& mesh) {
    std::vector<std::pair<int, int>> pairs;
    for (const auto& tetrahedron : mesh.tetrahedra) {
        for (const int a : tetrahedron) {
            for (const int b : tetrahedron) {
                if (a != b) pairs.emplace_back(a, b);
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    Graph graph;
    graph.begin.assign(mesh.vertices_mm.size() + 1, 0);
    for (const auto& [a, b] : pairs) {
        ++graph.begin[a + 1];
        graph.neighbour.push_back(b);
    }
    std::partial_sum(graph.begin.begin(), graph.begin.end(), graph.begin.begin());
    return graph;
}

constexpr double unreached = std::numeric_limits<double>::infinity();

// Shortest distances along edges from `start`, written over `distance` where they are smaller.
// Returns the vertices reached, nearest first.
std::vector<int> reach_from(int start, const TetMesh& mesh, const Graph& graph,
                            std::vector<double>& distance) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::vector<int> order;
    distance[start] = 0.0;
    queue.push({0.0, start});
    while (!queue.empty()) {
        const auto [d, v] = queue.top();
        queue.pop();
        if (d > distance[v]) continue;
        order.push_back(v);
        for (int k = graph.begin[v]; k < graph.begin[v + 1]; ++k) {
            const int w = graph.neighbour[k];
            const double next = d + (mesh.vertices_mm[w] - mesh.vertices_mm[v]).norm();
            if (next < distance[w]) {
                distance[w] = next;
                queue.push({next, w});
            }
        }
    }
    return order;
}

// Radius of a tube of the same volume and surface: 2 V / S.
double tube_radius(const TetMesh& mesh) {
    double surface = 0.0;
    for (const auto& [a, b, c] : boundary_triangles(mesh)) {
        const Vec3& p = mesh.vertices_mm[a];
        surface += 0.5 * (mesh.vertices_mm[b] - p).cross(mesh.vertices_mm[c] - p).norm();
    }
    return surface > 0.0 ? 2.0 * std::abs(volume_mm3(mesh)) / surface : 0.0;
}

// Adds one tree: the connected slices of `order`, which is sorted by `distance`.
void add_slices(const TetMesh& mesh, const Graph& graph, const std::vector<int>& order,
                const std::vector<double>& distance, double spacing, FrameSkeleton& skeleton,
                std::vector<int>& node_of) {
    const double length = distance[order.back()];
    const double slices = std::max(1.0, std::round(length / spacing));
    const auto slice_of = [&](int v) {
        return length > 0.0 ? std::min(std::floor(distance[v] / length * slices), slices - 1.0)
                            : 0.0;
    };
    for (const int seed : order) {
        if (node_of[seed] >= 0) continue;
        const int node = skeleton.size();
        std::vector<int> members{seed};
        node_of[seed] = node;
        int parent = -1;
        for (std::size_t m = 0; m < members.size(); ++m) {
            const int v = members[m];
            for (int k = graph.begin[v]; k < graph.begin[v + 1]; ++k) {
                const int w = graph.neighbour[k];
                if (node_of[w] < 0 && slice_of(w) == slice_of(seed)) {
                    node_of[w] = node;
                    members.push_back(w);
                } else if (node_of[w] >= 0 && node_of[w] != node) {
                    // Where slices of two arms meet, the loop is cut: the latest one is parent.
                    parent = std::max(parent, node_of[w]);
                }
            }
        }
        Vec3 centre = Vec3::Zero();
        for (const int v : members) centre += mesh.vertices_mm[v];
        centre /= static_cast<double>(members.size());
        double spread = 0.0;
        for (const int v : members) {
            spread = std::max(spread, (mesh.vertices_mm[v] - centre).norm());
        }
        skeleton.positions_mm.push_back(centre);
        skeleton.radii_mm.push_back(std::max(spread, 0.5 * spacing));
        skeleton.parent.push_back(parent);
    }
}

}  // namespace

FrameSkeleton skeleton_of_mesh(const TetMesh& mesh, double spacing_diameters) {
    const Graph graph = edges_of(mesh);
    const double spacing = 2.0 * spacing_diameters * tube_radius(mesh);
    FrameSkeleton skeleton;
    std::vector<int> node_of(mesh.vertices_mm.size(), -1);
    std::vector<double> distance(mesh.vertices_mm.size(), unreached);
    for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v) {
        if (node_of[v] >= 0) continue;
        // The vertex farthest from any vertex is an end; ranks are distances from there.
        std::vector<int> order = reach_from(static_cast<int>(v), mesh, graph, distance);
        const int end = order.back();
        for (const int w : order) distance[w] = unreached;
        order = reach_from(end, mesh, graph, distance);
        const double length = distance[order.back()];
        const double positive = spacing > 0.0 ? spacing : std::max(length, 1.0);
        add_slices(mesh, graph, order, distance, positive, skeleton, node_of);
    }
    return skeleton;
}

}  // namespace hepatica
