// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/near_pairs.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr std::size_t pairs_per_block = 16;
constexpr std::size_t sets_per_block = 256;

// Squared distance of two boxes.
double squared_gap(const Box& a, const Box& b) {
    const Vec3 zero = Vec3::Zero();
    return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(zero).squaredNorm();
}

Box box_of(const Segment& segment) {
    return {segment[0].cwiseMin(segment[1]), segment[0].cwiseMax(segment[1])};
}

bool shares(const std::array<int, 4>& nodes, int first_count) {
    for (int a = 0; a < first_count; ++a)
        for (int b = first_count; b < 4; ++b)
            if (nodes[a] == nodes[b]) return true;
    return false;
}

}  // namespace

NearPairs::NearPairs(const SurfaceFeatures& features)
    : features_(features),
      patches_(features.surface().size()),
      triangles_(features.surface().triangles().size()) {}

NearPairs::~NearPairs() = default;

template <class Nodes>
NearPairs::Moving NearPairs::moving(const Nodes& nodes, std::span<const Vec3> from_mm,
                                    std::span<const Vec3> to_mm) {
    Moving set;
    for (const int v : nodes) {
        set.box.add(from_mm[v]);
        set.motion_mm += to_mm[v] - from_mm[v];
    }
    set.motion_mm /= static_cast<double>(nodes.size());
    for (const int v : nodes)
        set.spread_mm =
            std::max(set.spread_mm, (to_mm[v] - from_mm[v] - set.motion_mm).squaredNorm());
    set.spread_mm = std::sqrt(set.spread_mm);
    return set;
}

double NearPairs::range_mm(const Moving& a, const Moving& b, double reach_mm) {
    return reach_mm + a.spread_mm + b.spread_mm + (a.motion_mm - b.motion_mm).norm();
}

bool NearPairs::may_meet(const Moving& a, const Moving& b, double reach_mm) {
    const double range = range_mm(a, b, reach_mm);
    return squared_gap(a.box, b.box) <= range * range;
}

// By boxes around the whole motion, seen from their common motion.
std::vector<std::array<int, 2>> NearPairs::pairs_of_patches(double reach_mm) {
    Vec3 common = Vec3::Zero();
    for (const Moving& patch : patches_) common += patch.motion_mm;
    common /= static_cast<double>(patches_.size());
    std::vector<Box> boxes;
    for (const Moving& patch : patches_) {
        Box box = patch.box;
        box.add(patch.box.low + patch.motion_mm - common);
        box.add(patch.box.high + patch.motion_mm - common);
        box.grow(patch.spread_mm + 0.5 * reach_mm);
        boxes.push_back(box);
    }
    if (tree_)
        tree_->refit(boxes);
    else
        tree_ = std::make_unique<PatchTree>(boxes);
    auto pairs = tree_->meeting_pairs();
    std::erase_if(pairs, [&](const auto& pair) {
        return !may_meet(patches_[pair[0]], patches_[pair[1]], reach_mm);
    });
    for (std::size_t p = 0; p < patches_.size(); ++p)
        pairs.push_back({static_cast<int>(p), static_cast<int>(p)});
    return pairs;
}

std::vector<FeaturePair> NearPairs::along(
    std::span<const Vec3> from_mm, std::span<const Vec3> to_mm, double reach_mm,
    const std::function<bool(int patch, int other)>& left_out) {
    from_mm_ = from_mm;
    to_mm_ = to_mm;
    reach_mm_ = reach_mm;
    const SurfacePatches& surface = features_.surface();
    parallel_blocks(triangles_.size(), sets_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            triangles_[t] = moving(surface.triangles()[t], from_mm, to_mm);
    });
    for (std::size_t p = 0; p < patches_.size(); ++p)
        patches_[p] = moving(surface.vertices_of(p), from_mm, to_mm);
    auto pairs = pairs_of_patches(reach_mm);
    std::erase_if(pairs, [&](const auto& pair) { return left_out(pair[0], pair[1]); });
    const std::size_t blocks = (pairs.size() + pairs_per_block - 1) / pairs_per_block;
    std::vector<std::vector<FeaturePair>> found(blocks);
    parallel_blocks(pairs.size(), pairs_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            add_pairs_of(pairs[k][0], pairs[k][1], found[begin / pairs_per_block]);
    });
    std::vector<FeaturePair> all;
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
}

void NearPairs::add_pairs_of(int patch, int other, std::vector<FeaturePair>& found) const {
    const SurfacePatches& surface = features_.surface();
    if (patch == other) {
        const auto triangles = surface.triangles_of(patch);
        for (std::size_t i = 0; i < triangles.size(); ++i)
            for (std::size_t j = i + 1; j < triangles.size(); ++j)
                add_pairs_of_triangles(triangles[i], triangles[j], found);
        return;
    }
    std::vector<int> near;
    for (const int t : surface.triangles_of(other))
        if (may_meet(patches_[patch], triangles_[t], reach_mm_)) near.push_back(t);
    if (near.empty()) return;
    for (const int t : surface.triangles_of(patch)) {
        if (!may_meet(patches_[other], triangles_[t], reach_mm_)) continue;
        for (const int s : near) add_pairs_of_triangles(t, s, found);
    }
}

void NearPairs::add_pairs_of_triangles(int a, int b, std::vector<FeaturePair>& found) const {
    const double range = range_mm(triangles_[a], triangles_[b], reach_mm_);
    if (squared_gap(triangles_[a].box, triangles_[b].box) > range * range) return;
    for (const int v : features_.nodes_owned_by(a)) add_vertex(v, b, range, found);
    for (const int v : features_.nodes_owned_by(b)) add_vertex(v, a, range, found);
    for (const int e : features_.edges_owned_by(a))
        for (const int f : features_.edges_owned_by(b)) add_edges(e, f, range, found);
}

void NearPairs::add_vertex(int node, int triangle, double range_mm,
                           std::vector<FeaturePair>& found) const {
    const Vec3& x = from_mm_[node];
    if (squared_gap({x, x}, triangles_[triangle].box) > range_mm * range_mm) return;
    const auto& corners = features_.surface().triangles()[triangle];
    const FeaturePair pair{
        .first = node, .second = triangle, .nodes = {node, corners[0], corners[1], corners[2]}};
    if (shares(pair.nodes, 1)) return;
    add(pair, closest(x, corners_of(corners, from_mm_)).squared_mm2, found);
}

void NearPairs::add_edges(int edge, int other, double range_mm,
                          std::vector<FeaturePair>& found) const {
    const auto& a = features_.edges()[std::min(edge, other)];
    const auto& b = features_.edges()[std::max(edge, other)];
    const FeaturePair pair{.of_edges = true,
                           .first = std::min(edge, other),
                           .second = std::max(edge, other),
                           .nodes = {a[0], a[1], b[0], b[1]}};
    if (shares(pair.nodes, 2)) return;
    const Segment first{from_mm_[a[0]], from_mm_[a[1]]}, second{from_mm_[b[0]], from_mm_[b[1]]};
    if (squared_gap(box_of(first), box_of(second)) > range_mm * range_mm) return;
    add(pair, closest(first, second).squared_mm2, found);
}

// Points between corners move by means of what these move by.
void NearPairs::add(FeaturePair pair, double squared_mm2, std::vector<FeaturePair>& found) const {
    const int first_count = pair.of_edges ? 2 : 1;
    double relative = 0.0;
    for (int a = 0; a < first_count; ++a)
        for (int b = first_count; b < 4; ++b) {
            const int i = pair.nodes[a], j = pair.nodes[b];
            relative = std::max(relative,
                                (to_mm_[i] - from_mm_[i] - to_mm_[j] + from_mm_[j]).squaredNorm());
        }
    pair.apart_mm = std::sqrt(squared_mm2);
    pair.approach_mm = std::sqrt(relative);
    if (pair.apart_mm - pair.approach_mm <= reach_mm_) found.push_back(pair);
}

}  // namespace hepatica
