// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/weak_edges.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/tear/tearing.h"

namespace hepatica {

namespace {

using Edge = std::array<int, 2>;

Edge edge_of(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

void sort_once(std::vector<Edge>& edges) {
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

// Both sides of a joint that holds have the same corners.
std::vector<Edge> edges_of(const TornTopology& topology, const std::vector<int>& joints) {
    std::vector<Edge> edges;
    for (const int j : joints) {
        const Joint& joint = topology.joints()[j];
        for (int k = 0; k < 3; ++k)
            edges.push_back(
                edge_of(topology.sides(joint, k)[0], topology.sides(joint, (k + 1) % 3)[0]));
    }
    sort_once(edges);
    return edges;
}

// The edges of the joints that are on the surface.
std::vector<Edge> edges_at(const TornTopology& topology, const std::vector<int>& joints) {
    const std::vector<Edge> all = edges_of(topology, joints);
    std::vector<std::uint8_t> has_edges(topology.vertex_count(), 0);
    for (const Edge& edge : all)
        for (const int v : edge) has_edges[v] = 1;
    std::vector<Edge> edges;
    for (const auto& triangle : topology.surface())
        for (int k = 0; k < 3; ++k) {
            const int a = triangle[k], b = triangle[(k + 1) % 3];
            if (has_edges[a] && has_edges[b] && std::ranges::binary_search(all, edge_of(a, b)))
                edges.push_back(edge_of(a, b));
        }
    sort_once(edges);
    return edges;
}

}  // namespace

WeakEdges::Edges WeakEdges::of(const Tearing& tearing) {
    const TornTopology& topology = tearing.topology();
    std::vector<int> joints = tearing.weakened();
    if (joints == joints_ && topology.version() == version_ && topology.vertex_count() == vertices_)
        return edges_;
    std::vector<Edge> edges;
    if (!joints.empty()) edges = edges_at(topology, joints);
    joints_ = std::move(joints);
    version_ = topology.version();
    vertices_ = topology.vertex_count();
    edges_ = edges.empty() ? nullptr : std::make_shared<const std::vector<Edge>>(std::move(edges));
    return edges_;
}

}  // namespace hepatica
