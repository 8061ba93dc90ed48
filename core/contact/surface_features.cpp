// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/surface_features.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/disjoint_sets.h"

namespace hepatica {
namespace {

constexpr double flat = 1e-6;  // radians: rounding

void sort_each_once(std::vector<int>& numbers) {
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

double distance_mm(const FeaturePair& pair, std::span<const Vec3> positions_mm) {
    const auto at = [&](int k) { return positions_mm[pair.nodes[k]]; };
    return std::sqrt(pair.of_edges
                         ? closest(Segment{at(0), at(1)}, Segment{at(2), at(3)}).squared_mm2
                         : closest(at(0), Triangle{at(1), at(2), at(3)}).squared_mm2);
}

SurfaceFeatures::SurfaceFeatures(SurfacePatches surface, std::span<const Vec3> rest_positions_mm,
                                 std::span<const SurfaceKind> kind_of_node)
    : surface_(std::move(surface)),
      owned_nodes_(surface_.triangles().size()),
      owned_edges_(surface_.triangles().size()),
      patch_of_(surface_.triangles().size()),
      patches_of_node_(rest_positions_mm.size()),
      neighbours_above_(surface_.size()),
      node_area_mm2_(rest_positions_mm.size(), 0.0) {
    for (std::size_t p = 0; p < surface_.size(); ++p)
        for (const int t : surface_.triangles_of(p)) patch_of_[t] = static_cast<int>(p);
    std::vector<double> area_mm2;
    for (std::size_t t = 0; t < surface_.triangles().size(); ++t) {
        const Triangle x = corners_of(surface_.triangles()[t], rest_positions_mm);
        area_mm2.push_back(0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm());
        for (const int node : surface_.triangles()[t]) {
            if (patches_of_node_[node].empty()) {
                nodes_.push_back(node);
                owned_nodes_[t].push_back(node);
            }
            patches_of_node_[node].push_back(patch_of_[t]);
            node_area_mm2_[node] += area_mm2.back() / 3.0;
        }
    }
    std::ranges::sort(nodes_);
    find_edges(area_mm2);
    find_borders();
    find_pieces();
    find_kinds(kind_of_node);
    if (beside_obstacles_) find_sharpness(kind_of_node, rest_positions_mm);
}

void SurfaceFeatures::find_kinds(std::span<const SurfaceKind> kind_of_node) {
    kind_of_piece_.assign(patches_of_piece_.size(), SurfaceKind::moving);
    if (kind_of_node.empty()) return;
    for (std::size_t piece = 0; piece < kind_of_piece_.size(); ++piece) {
        const int node = surface_.vertices_of(patches_of_piece_[piece].front()).front();
        kind_of_piece_[piece] = kind_of_node[node];
        beside_obstacles_ |= kind_of_node[node] != SurfaceKind::moving;
    }
}

// From the normals of the two triangles at an edge; concave edges have sharpness 0.
void SurfaceFeatures::find_sharpness(std::span<const SurfaceKind> kind_of_node,
                                     std::span<const Vec3> positions_mm) {
    edge_sharpness_.assign(edges_.size(), 0.0);
    node_sharpness_.assign(kind_of_node.size(), 0.0);
    std::map<std::pair<int, int>, Vec3> normal_beside;
    for (const auto& triangle : surface_.triangles()) {
        if (kind_of_node[triangle[0]] == SurfaceKind::moving) continue;
        const Triangle x = corners_of(triangle, positions_mm);
        const Vec3 normal = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
        for (int a = 0; a < 3; ++a) normal_beside[{triangle[a], triangle[(a + 1) % 3]}] = normal;
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const auto [a, b] = edges_[e];
        const auto there = normal_beside.find({a, b}), back = normal_beside.find({b, a});
        if (there == normal_beside.end() || back == normal_beside.end()) continue;
        const Vec3 along = positions_mm[b] - positions_mm[a];
        const double outwards = there->second.cross(back->second).dot(along);
        if ((kind_of_node[a] == SurfaceKind::shell) != (outwards < 0.0)) continue;
        const double sharpness = std::min(1.0, (there->second - back->second).norm());
        if (sharpness < flat) continue;
        edge_sharpness_[e] = sharpness;
        for (const int node : {a, b})
            node_sharpness_[node] = std::max(node_sharpness_[node], sharpness);
    }
}

void SurfaceFeatures::find_borders() {
    for (auto& patches : patches_of_edge_) sort_each_once(patches);
    for (auto& patches : patches_of_node_) {
        sort_each_once(patches);
        for (const int p : patches)
            for (const int q : patches)
                if (p < q) neighbours_above_[p].push_back(q);
    }
    for (auto& patches : neighbours_above_) sort_each_once(patches);
}

bool SurfaceFeatures::neighbours(int patch, int other) const {
    return std::ranges::binary_search(neighbours_above_[std::min(patch, other)],
                                      std::max(patch, other));
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
                patches_of_edge_.emplace_back();
                owned_edges_[t].push_back(at->second);
            }
            edge_area_mm2_[at->second] += area_mm2[t] / 3.0;
            patches_of_edge_[at->second].push_back(patch_of_[t]);
        }
}

bool SurfaceFeatures::counts(const FeaturePair& pair, const LeftOut& left_out) const {
    const auto first = pair.of_edges ? patches_of_edge(pair.first) : patches_of_node(pair.first);
    const auto second =
        pair.of_edges ? patches_of_edge(pair.second) : std::span(&patch_of_[pair.second], 1);
    return std::ranges::any_of(first, [&](int p) {
        return std::ranges::any_of(second, [&](int q) { return !left_out(p, q); });
    });
}

// Counts one header per triangle for nested vectors.
std::size_t SurfaceFeatures::bytes() const {
    const std::size_t triangles = surface_.triangles().size();
    return triangles * (3 * sizeof(int) + 2 * sizeof(std::vector<int>) + 4 * sizeof(int)) +
           edges_.size() * (4 * sizeof(int) + sizeof(double) + sizeof(std::vector<int>)) +
           node_area_mm2_.size() * (sizeof(double) + sizeof(std::vector<int>)) +
           nodes_.size() * 3 * sizeof(int);
}

void SurfaceFeatures::find_pieces() {
    DisjointSets sets(node_area_mm2_.size());
    for (const auto& [a, b, c] : surface_.triangles()) {
        sets.unite(a, b);
        sets.unite(a, c);
    }
    std::map<std::uint32_t, int> number_of;
    for (std::size_t p = 0; p < surface_.size(); ++p) {
        const std::uint32_t first = sets.root(surface_.vertices_of(p).front());
        const auto made = number_of.try_emplace(first, static_cast<int>(number_of.size())).first;
        piece_of_patch_.push_back(made->second);
    }
    pieces_ = static_cast<int>(number_of.size());
    patches_of_piece_.resize(number_of.size());
    for (std::size_t p = 0; p < surface_.size(); ++p)
        patches_of_piece_[piece_of_patch_[p]].push_back(static_cast<int>(p));
}

}  // namespace hepatica
