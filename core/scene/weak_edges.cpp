// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/weak_edges.h"

#include <algorithm>
#include <utility>

#include "core/tear/tearing.h"

namespace hepatica {

namespace {

using Edge = std::array<int, 2>;

Edge edge_of(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

std::vector<Edge> edges_of_surface(const TornTopology& topology) {
    std::vector<Edge> edges;
    for (const auto& [a, b, c] : topology.surface())
        for (const Edge& edge : {edge_of(a, b), edge_of(b, c), edge_of(c, a)})
            edges.push_back(edge);
    std::ranges::sort(edges);
    return edges;
}

// Of a joint that holds, both sides have the same corners.
std::vector<Edge> edges_at(const TornTopology& topology, const std::vector<int>& joints) {
    const std::vector<Edge> surface = edges_of_surface(topology);
    std::vector<Edge> edges;
    for (const int j : joints) {
        const Joint& joint = topology.joints()[j];
        std::array<int, 3> corners;
        for (int k = 0; k < 3; ++k) corners[k] = topology.sides(joint, k)[0];
        for (int k = 0; k < 3; ++k) {
            const Edge edge = edge_of(corners[k], corners[(k + 1) % 3]);
            if (std::ranges::binary_search(surface, edge)) edges.push_back(edge);
        }
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
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
