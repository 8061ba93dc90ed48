// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/cluster_pairs.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hepatica {

ClusterPairs::ClusterPairs(const SurfaceFeatures& features, int patch, std::vector<int> others)
    : patch_(patch), others_(std::move(others)) {
    const auto add_nodes = [&](int p) {
        const auto nodes = features.surface().vertices_of(static_cast<std::size_t>(p));
        nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
    };
    add_nodes(patch_);
    for (const int other : others_)
        if (other != patch_) add_nodes(other);
    std::ranges::sort(nodes_);
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

std::size_t ClusterPairs::bytes() const {
    return sizeof(ClusterPairs) + (others_.capacity() + nodes_.capacity()) * sizeof(int) +
           shape_mm_.capacity() * sizeof(Vec3) + pairs_.capacity() * sizeof(Known);
}

// The largest distance in the stored shape of a pair that may come within the reach.
double ClusterPairs::needed_mm(const Sweep& sweep, std::optional<double> goes_on_mm) {
    const auto fit = [&](std::span<const Vec3> positions_mm, const RigidFit& guess) {
        return fit_rigid(shape_mm_, nodes_, positions_mm, guess.turn);
    };
    begins_ = goes_on_mm ? ends_ : fit(sweep.from_mm, ends_);
    begins_.beside_mm += goes_on_mm.value_or(0.0);
    ends_ = sweep.stands() ? begins_ : fit(sweep.to_mm, begins_);
    const double beside = std::max(begins_.beside_mm, ends_.beside_mm);
    const double shrunk = std::abs(begins_.turn.dot(ends_.turn));
    return (sweep.reach_mm + 2.0 * beside) / shrunk;
}

void ClusterPairs::take_shape(std::span<const Vec3> positions_mm) {
    Vec3 centre = Vec3::Zero();
    for (const int v : nodes_) centre += positions_mm[v];
    centre /= static_cast<double>(nodes_.size());
    shape_mm_.clear();
    for (const int v : nodes_) shape_mm_.push_back(positions_mm[v] - centre);
    begins_ = ends_ = {};
    known_to_mm_ = -1.0;
}

// Searches at the positions where the shape was taken.
void ClusterPairs::search_here(const Sweep& sweep, double slack_mm, PatchPairSearch& search) {
    ++searches_;
    known_to_mm_ = sweep.reach_mm + 2.0 * slack_mm;
    std::vector<FeaturePair> near;
    add_all({sweep.from_mm, sweep.from_mm, known_to_mm_}, search, near);
    pairs_.clear();
    for (const FeaturePair& pair : near) {
        const double apart = distance_mm(pair, sweep.from_mm);
        if (apart <= known_to_mm_) pairs_.push_back({apart, pair});
    }
    std::ranges::sort(pairs_, {}, [](const Known& known) { return known.apart_mm; });
}

void ClusterPairs::add_all(const Sweep& sweep, PatchPairSearch& search,
                           std::vector<FeaturePair>& found) const {
    for (const int other : others_) search.add_pairs_of(patch_, other, sweep, found);
}

void ClusterPairs::add_along(const Sweep& sweep, double slack_mm, std::optional<double> goes_on_mm,
                             PatchPairSearch& search, std::vector<FeaturePair>& found) {
    double needed = known_to_mm_ >= 0.0 ? needed_mm(sweep, goes_on_mm) : INFINITY;
    if (!(needed <= known_to_mm_)) {
        take_shape(sweep.from_mm);
        needed = needed_mm(sweep, 0.0);
        if (!(needed <= sweep.reach_mm + 2.0 * slack_mm)) {
            add_all(sweep, search, found);
            return;
        }
        search_here(sweep, slack_mm, search);
    }
    for (const Known& known : pairs_) {
        if (known.apart_mm > needed) break;
        found.push_back(known.pair);
    }
}

}  // namespace hepatica
