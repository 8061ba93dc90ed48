// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/surface_features.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace hepatica {

SurfaceFeatures::SurfaceFeatures(SurfacePatches surface, std::span<const Vec3> rest_positions_mm)
    : surface_(std::move(surface)),
      owned_nodes_(surface_.triangles().size()),
      owned_edges_(surface_.triangles().size()),
      owner_of_node_(rest_positions_mm.size(), -1),
      patch_of_(surface_.triangles().size()),
      node_area_mm2_(rest_positions_mm.size(), 0.0) {
    std::vector<double> area_mm2;
    for (std::size_t t = 0; t < surface_.triangles().size(); ++t) {
        const Triangle x = corners_of(surface_.triangles()[t], rest_positions_mm);
        area_mm2.push_back(0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm());
        for (const int node : surface_.triangles()[t]) {
            if (owner_of_node_[node] < 0) {
                owner_of_node_[node] = static_cast<int>(t);
                nodes_.push_back(node);
                owned_nodes_[t].push_back(node);
            }
            node_area_mm2_[node] += area_mm2.back() / 3.0;
        }
    }
    std::ranges::sort(nodes_);
    find_edges(area_mm2);
    find_pieces();
}

void SurfaceFeatures::find_edges(std::span<const double> area_mm2) {
    std::map<std::pair<int, int>, int> number_of;
    for (std::size_t t = 0; t < surface_.triangles().size(); ++t)
        for (int a = 0; a < 3; ++a) {
            const int i = surface_.triangles()[t][a], j = surface_.triangles()[t][(a + 1) % 3];
            const auto [at, made] =
                number_of.try_emplace(std::minmax(i, j), static_cast<int>(edges_.size()));
            if (made) {
                edges_.push_back({std::min(i, j), std::max(i, j)});
                edge_area_mm2_.push_back(0.0);
                owner_of_edge_.push_back(static_cast<int>(t));
                owned_edges_[t].push_back(at->second);
            }
            edge_area_mm2_[at->second] += area_mm2[t] / 3.0;
        }
}

// Lists of lists have a head for each triangle.
std::size_t SurfaceFeatures::bytes() const {
    const std::size_t triangles = surface_.triangles().size();
    return triangles * (3 * sizeof(int) + 2 * sizeof(std::vector<int>) + 4 * sizeof(int)) +
           edges_.size() * (2 * sizeof(int) + sizeof(double) + 2 * sizeof(int)) +
           node_area_mm2_.size() * (sizeof(double) + sizeof(int)) + nodes_.size() * 2 * sizeof(int);
}

void SurfaceFeatures::find_pieces() {
    std::vector<int> root(node_area_mm2_.size());
    std::iota(root.begin(), root.end(), 0);
    const auto root_of = [&](int node) {
        while (root[node] != node) node = root[node] = root[root[node]];
        return node;
    };
    for (const auto& triangle : surface_.triangles())
        for (const int node : triangle) {
            const int a = root_of(node), b = root_of(triangle[0]);
            root[std::max(a, b)] = std::min(a, b);
        }
    std::map<int, int> number_of;
    for (std::size_t p = 0; p < surface_.size(); ++p) {
        for (const int t : surface_.triangles_of(p)) patch_of_[t] = static_cast<int>(p);
        const int first = root_of(surface_.vertices_of(p).front());
        const auto made = number_of.try_emplace(first, static_cast<int>(number_of.size())).first;
        piece_of_patch_.push_back(made->second);
    }
    pieces_ = static_cast<int>(number_of.size());
}

}  // namespace hepatica
