// SPDX-License-Identifier: GPL-3.0-or-later
// The skeleton of a mesh without centrelines: the Reeb graph of the distance along mesh edges.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "core/deform/solvers/coarse_skeleton.h"

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

// Dijkstra: shortest distances along edges from `start`, written to `distance` where they are
// smaller. Returns the vertices reached, nearest first.
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

// Radius of a tube with the same volume and surface: 2 V / S.
double tube_radius(const TetMesh& mesh) {
    double surface = 0.0;
    for (const auto& [a, b, c] : boundary_triangles(mesh)) {
        const Vec3& p = mesh.vertices_mm[a];
        surface += 0.5 * (mesh.vertices_mm[b] - p).cross(mesh.vertices_mm[c] - p).norm();
    }
    return surface > 0.0 ? 2.0 * std::abs(volume_mm3(mesh)) / surface : 0.0;
}

// Connected vertices whose distances are in the same slice.
struct Piece {
    std::vector<int> members;
    int parent = -1;  // node of the skeleton
    Vec3 centre = Vec3::Zero();
};

// Grows a piece from `seed` within its slice; marks its vertices with `node`.
Piece grow(int seed, int node, const TetMesh& mesh, const Graph& graph,
           const std::vector<int>& slice, std::vector<int>& node_of) {
    Piece piece;
    piece.members = {seed};
    node_of[seed] = node;
    for (std::size_t m = 0; m < piece.members.size(); ++m) {
        const int v = piece.members[m];
        piece.centre += mesh.vertices_mm[v];
        for (int k = graph.begin[v]; k < graph.begin[v + 1]; ++k) {
            const int w = graph.neighbour[k];
            if (node_of[w] < 0 && slice[w] == slice[seed]) {
                node_of[w] = node;
                piece.members.push_back(w);
            } else if (node_of[w] >= 0 && slice[w] < slice[seed]) {
                // Where the two arms of a loop meet, the loop is cut: the node added last is the
                // parent.
                piece.parent = std::max(piece.parent, node_of[w]);
            }
        }
    }
    piece.centre /= static_cast<double>(piece.members.size());
    return piece;
}

// Whether they are the same node, or one is the parent of the other.
bool related(const CoarseSkeleton& skeleton, int a, int b) {
    return a == b || (a >= 0 && skeleton.parent[a] == b) || (b >= 0 && skeleton.parent[b] == a);
}

// Adds one tree: the connected slices of `order`, which is sorted by `distance`. Pieces of a slice
// that touch related nodes and whose centres are within a diameter of each other are merged,
// because a thin slice through a coarse mesh may fall apart where the body does not branch.
void add_slices(const TetMesh& mesh, const Graph& graph, const std::vector<int>& order,
                const std::vector<double>& distance, double spacing, double radius,
                CoarseSkeleton& skeleton, std::vector<int>& node_of) {
    const double length = distance[order.back()];
    const double slices = std::max(1.0, std::round(length / spacing));
    std::vector<int> slice(node_of.size(), -1);
    for (const int v : order) {
        slice[v] = length > 0.0 ? static_cast<int>(std::min(
                                      std::floor(distance[v] / length * slices), slices - 1.0))
                                : 0;
    }
    int slice_begin = skeleton.size();  // first node of the current slice
    int current = -1;
    std::vector<std::vector<int>> members(static_cast<std::size_t>(skeleton.size()));
    for (const int seed : order) {
        if (node_of[seed] >= 0) continue;
        if (slice[seed] != current) slice_begin = skeleton.size();
        current = slice[seed];
        const int fresh = skeleton.size();
        const Piece piece = grow(seed, fresh, mesh, graph, slice, node_of);
        int node = slice_begin;
        while (node < fresh &&
               (!related(skeleton, skeleton.parent[node], piece.parent) ||
                (skeleton.positions_mm[node] - piece.centre).norm() > 2.0 * radius)) {
            ++node;
        }
        if (node == fresh) {
            skeleton.positions_mm.push_back(piece.centre);
            skeleton.radii_mm.push_back(std::max(radius, 0.5 * spacing));
            skeleton.parent.push_back(piece.parent);
            members.push_back(piece.members);
            continue;
        }
        const double before = static_cast<double>(members[node].size());
        const double added = static_cast<double>(piece.members.size());
        skeleton.positions_mm[node] =
            (before * skeleton.positions_mm[node] + added * piece.centre) / (before + added);
        for (const int v : piece.members) {
            node_of[v] = node;
            members[node].push_back(v);
        }
    }
}

}  // namespace

CoarseSkeleton skeleton_of_mesh(const TetMesh& mesh, double spacing_diameters) {
    const Graph graph = edges_of(mesh);
    const double radius = tube_radius(mesh);
    const double spacing = 2.0 * spacing_diameters * radius;
    CoarseSkeleton skeleton;
    std::vector<int> node_of(mesh.vertices_mm.size(), -1);
    std::vector<double> distance(mesh.vertices_mm.size(), unreached);
    for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v) {
        if (node_of[v] >= 0) continue;
        // The vertex farthest from any vertex is an end; distances are measured from it.
        std::vector<int> order = reach_from(static_cast<int>(v), mesh, graph, distance);
        const int end = order.back();
        for (const int w : order) distance[w] = unreached;
        order = reach_from(end, mesh, graph, distance);
        const double length = distance[order.back()];
        const double positive = spacing > 0.0 ? spacing : std::max(length, 1.0);
        add_slices(mesh, graph, order, distance, positive, radius, skeleton, node_of);
    }
    return skeleton;
}

}  // namespace hepatica
