// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/torn_sides.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace hepatica {
namespace {

constexpr double rounding = 1e-9;  // of the weights of a point in a triangle

std::array<int, 2> ascending(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

int nodes_of_first(const FeaturePair& pair) {
    return pair.of_edges ? 2 : 1;
}

// Whether `holds(a, b)` for a node of each feature.
template <class Holds>
bool any_of_both(const FeaturePair& pair, const Holds& holds) {
    for (int a = 0; a < nodes_of_first(pair); ++a)
        for (int b = nodes_of_first(pair); b < 4; ++b)
            if (holds(pair.nodes[a], pair.nodes[b])) return true;
    return false;
}

// At the corner of the triangle that is this node.
double angle_at(int node, const std::array<int, 3>& corners, std::span<const Vec3> x) {
    const auto at = std::ranges::find(corners, node) - corners.begin();
    const Vec3 e = x[corners[(at + 1) % 3]] - x[node], f = x[corners[(at + 2) % 3]] - x[node];
    return std::atan2(e.cross(f).norm(), e.dot(f));
}

// The other corners of these triangles, each once.
std::vector<int> neighbours(int node, std::span<const int> triangles,
                            const std::vector<std::array<int, 3>>& corners) {
    std::vector<int> others;
    for (const int t : triangles)
        for (const int v : corners[t])
            if (v != node) others.push_back(v);
    std::ranges::sort(others);
    others.erase(std::unique(others.begin(), others.end()), others.end());
    return others;
}

// Triangles that share a vertex always meet there, and cross where the side of one that lies
// opposite meets the other. Those that share a side do not.
bool cross(const std::array<int, 3>& one, const std::array<int, 3>& other,
           std::span<const Vec3> x) {
    const auto is_shared = [](int v, const std::array<int, 3>& by) {
        return std::ranges::find(by, v) != by.end();
    };
    const auto shared = std::ranges::count_if(one, [&](int v) { return is_shared(v, other); });
    if (shared == 0) return squared_distance_mm2(corners_of(one, x), corners_of(other, x)) == 0.0;
    if (shared > 1) return false;
    const auto side_meets = [&](const std::array<int, 3>& its, const std::array<int, 3>& triangle) {
        std::vector<Vec3> side;
        for (const int v : its)
            if (!is_shared(v, triangle)) side.push_back(x[v]);
        return closest(Segment{side[0], side[1]}, corners_of(triangle, x)).squared_mm2 == 0.0;
    };
    return side_meets(one, other) || side_meets(other, one);
}

}  // namespace

TornSides::PatchPairs TornSides::follow_split(const Twins& before, std::span<const int> node_before,
                                              std::vector<int> node_of_whole) {
    node_of_whole_ = std::move(node_of_whole);
    std::map<int, std::vector<int>> children;
    for (const int v : features_.nodes()) children[node_before[v]].push_back(v);
    lying_.clear();
    for (const auto& [node, parts] : children)
        for (std::size_t a = 0; a < parts.size(); ++a)
            for (std::size_t b = a + 1; b < parts.size(); ++b)
                lying_.push_back({parts[a], parts[b]});
    for (const auto& [one, other] : before)
        for (const int a : children[one])
            for (const int b : children[other]) lying_.push_back(ascending(a, b));
    std::ranges::sort(lying_);
    PatchPairs parted = give_up_parted();
    find_triangles();
    return parted;
}

// Removes twins of two pieces; the patches around them.
TornSides::PatchPairs TornSides::give_up_parted() {
    PatchPairs parted;
    std::erase_if(lying_, [&](const std::array<int, 2>& twins) {
        if (of_one_piece(twins)) return false;
        for (const int p : features_.patches_of_node(twins[0]))
            for (const int q : features_.patches_of_node(twins[1]))
                parted.push_back(ascending(p, q));
        return true;
    });
    std::ranges::sort(parted);
    parted.erase(std::unique(parted.begin(), parted.end()), parted.end());
    return parted;
}

void TornSides::find(std::span<const Vec3> positions_mm, double least_gap_mm) {
    if (node_of_whole_.empty()) return;
    const std::vector<int> whole = node_of_whole_;
    follow_split({}, whole, whole);
    let_go(positions_mm, least_gap_mm);
}

void TornSides::find_triangles() {
    triangles_of_node_.assign(node_of_whole_.size(), {});
    std::vector<char> twin(node_of_whole_.size(), 0);
    for (const auto& [a, b] : lying_) twin[a] = twin[b] = 1;
    const auto& triangles = features_.surface().triangles();
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const int v : triangles[t])
            if (v < static_cast<int>(twin.size()) && twin[v])
                triangles_of_node_[v].push_back(static_cast<int>(t));
}

bool TornSides::is_lying(int node, int other) const {
    return node_of_whole_[node] == node_of_whole_[other] &&
           std::ranges::binary_search(lying_, ascending(node, other));
}

bool TornSides::lie_on_each_other(const FeaturePair& pair) const {
    return !lying_.empty() && any_of_both(pair, [this](int a, int b) { return is_lying(a, b); });
}

bool TornSides::shared_a_vertex(const FeaturePair& pair) const {
    return !node_of_whole_.empty() && any_of_both(pair, [this](int a, int b) {
        return node_of_whole_[a] == node_of_whole_[b];
    });
}

bool TornSides::outside(int node, int twin, std::span<const Vec3> positions_mm) const {
    const auto& corners = features_.surface().triangles();
    const Vec3& point = positions_mm[node];
    const auto nearest_on = [&](int t) {
        return closest(point, corners_of(corners[t], positions_mm));
    };
    const int nearest = *std::ranges::min_element(triangles_of_node_[twin], {},
                                                  [&](int t) { return nearest_on(t).squared_mm2; });
    const PointTriangle at = nearest_on(nearest);
    std::vector<int> feature;  // the corners of the triangle between which the nearest point lies
    for (int a = 0; a < 3; ++a)
        if (at.weights[a] > rounding) feature.push_back(corners[nearest][a]);
    Vec3 normal = Vec3::Zero();
    for (const int patch : features_.patches_of_node(feature.front()))
        for (const int t : features_.surface().triangles_of(patch)) {
            if (!std::ranges::all_of(feature, [&](int v) {
                    return std::ranges::find(corners[t], v) != corners[t].end();
                }))
                continue;
            const Triangle x = corners_of(corners[t], positions_mm);
            const double weight =
                feature.size() == 1 ? angle_at(feature.front(), corners[t], positions_mm) : 1.0;
            normal += weight * (x[1] - x[0]).cross(x[2] - x[0]).normalized();
        }
    return (point - point_at(corners_of(corners[nearest], positions_mm), at.weights)).dot(normal) >
           0.0;
}

std::vector<FeaturePair> TornSides::pairs_of(const std::array<int, 2>& twins) const {
    const auto& corners = features_.surface().triangles();
    std::vector<FeaturePair> pairs;
    for (const auto& [v, w] : {twins, std::array{twins[1], twins[0]}})
        for (const int t : triangles_of_node_[w])
            pairs.push_back(
                {.of_edges = false, .nodes = {v, corners[t][0], corners[t][1], corners[t][2]}});
    const auto [v, w] = twins;
    for (const int x : neighbours(v, triangles_of_node_[v], corners))
        for (const int y : neighbours(w, triangles_of_node_[w], corners))
            if (x != y && !is_lying(x, y))
                pairs.push_back({.of_edges = true, .nodes = {v, x, w, y}});
    return pairs;
}

bool TornSides::of_one_piece(const std::array<int, 2>& twins) const {
    const auto piece_of = [&](int node) {
        return features_.piece_of_patch(features_.patches_of_node(node).front());
    };
    return piece_of(twins[0]) == piece_of(twins[1]);
}

bool TornSides::any_cross(const std::array<int, 2>& twins,
                          std::span<const Vec3> positions_mm) const {
    const auto& corners = features_.surface().triangles();
    const auto held_back = [&](const std::array<int, 3>& one, const std::array<int, 3>& other) {
        for (const int a : one)
            for (const int b : other)
                if (a != b && ascending(a, b) != twins && is_lying(a, b)) return true;
        return false;
    };
    for (const int s : triangles_of_node_[twins[0]])
        for (const int t : triangles_of_node_[twins[1]])
            if (!held_back(corners[s], corners[t]) && cross(corners[s], corners[t], positions_mm))
                return true;
    return false;
}

bool TornSides::have_come_apart(const std::array<int, 2>& twins, std::span<const Vec3> positions_mm,
                                double least_gap_mm) const {
    const auto [v, w] = twins;
    if ((positions_mm[v] - positions_mm[w]).squaredNorm() < least_gap_mm * least_gap_mm)
        return false;
    return outside(v, w, positions_mm) && outside(w, v, positions_mm) &&
           std::ranges::all_of(pairs_of(twins),
                               [&](const FeaturePair& pair) {
                                   return distance_mm(pair, positions_mm) >= least_gap_mm;
                               }) &&
           !any_cross(twins, positions_mm);
}

std::vector<FeaturePair> TornSides::let_go(std::span<const Vec3> positions_mm,
                                           double least_gap_mm) {
    const auto still_lie = [&](const std::array<int, 2>& twins) {
        return !have_come_apart(twins, positions_mm, least_gap_mm);
    };
    const Twins before = lying_;
    Twins apart;
    std::ranges::remove_copy_if(before, std::back_inserter(apart), still_lie);
    // Pairs that twins have held back from each other count now: what is too near there stays.
    for (bool all = false; !all;) {
        lying_.clear();
        std::ranges::set_difference(before, apart, std::back_inserter(lying_));
        all = std::erase_if(apart, still_lie) == 0;
    }
    std::vector<FeaturePair> counting;
    for (const auto& twins : apart) {
        const std::vector<FeaturePair> pairs = pairs_of(twins);
        counting.insert(counting.end(), pairs.begin(), pairs.end());
    }
    return counting;
}

bool TornSides::set(const Twins& lying) {
    const int nodes = static_cast<int>(node_of_whole_.size());
    const auto are_twins = [&](const std::array<int, 2>& twins) {
        return twins[0] >= 0 && twins[0] < twins[1] && twins[1] < nodes &&
               node_of_whole_[twins[0]] == node_of_whole_[twins[1]] && of_one_piece(twins);
    };
    const auto unordered = [](const auto& a, const auto& b) { return a >= b; };
    if (!std::ranges::all_of(lying, are_twins) ||
        std::ranges::adjacent_find(lying, unordered) != lying.end())
        return false;
    lying_ = lying;
    find_triangles();
    return true;
}

}  // namespace hepatica
