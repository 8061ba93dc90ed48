// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/neighbour_pairs.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr std::size_t clusters_per_block = 16;

double distance_mm(const FeaturePair& pair, std::span<const Vec3> x) {
    const auto& n = pair.nodes;
    return std::sqrt(pair.of_edges
                         ? closest(Segment{x[n[0]], x[n[1]]}, Segment{x[n[2]], x[n[3]]}).squared_mm2
                         : closest(x[n[0]], Triangle{x[n[1]], x[n[2]], x[n[3]]}).squared_mm2);
}

}  // namespace

NeighbourPairs::NeighbourPairs(const SurfaceFeatures& features, const NearPairs& search,
                               double slack_mm)
    : search_(search), slack_mm_(slack_mm), clusters_(features.surface().size()) {
    for (std::size_t p = 0; p < clusters_.size(); ++p) {
        Cluster& cluster = clusters_[p];
        cluster.patches.push_back(static_cast<int>(p));
        const auto others = features.neighbours_above(static_cast<int>(p));
        cluster.patches.insert(cluster.patches.end(), others.begin(), others.end());
        for (const int q : cluster.patches) {
            const auto nodes = features.surface().vertices_of(q);
            cluster.nodes.insert(cluster.nodes.end(), nodes.begin(), nodes.end());
        }
        std::ranges::sort(cluster.nodes);
        const auto end = std::unique(cluster.nodes.begin(), cluster.nodes.end());
        cluster.nodes.erase(end, cluster.nodes.end());
    }
}

int NeighbourPairs::searches() const {
    int sum = 0;
    for (const Cluster& cluster : clusters_) sum += cluster.searches;
    return sum;
}

std::size_t NeighbourPairs::bytes() const {
    std::size_t sum = clusters_.size() * sizeof(Cluster);
    for (const Cluster& cluster : clusters_)
        sum += (cluster.patches.capacity() + cluster.nodes.capacity()) * sizeof(int) +
               cluster.shape_mm.capacity() * sizeof(Vec3) +
               cluster.pairs.capacity() * sizeof(Known);
    return sum;
}

// How far apart a pair of the shape may be that comes within the reach.
double NeighbourPairs::needed_mm(Cluster& cluster, const Sweep& sweep,
                                 std::optional<double> goes_on_mm) {
    const auto fit = [&](std::span<const Vec3> positions_mm, const RigidFit& guess) {
        return fit_rigid(cluster.shape_mm, cluster.nodes, positions_mm, guess.turn);
    };
    cluster.begins = goes_on_mm ? cluster.ends : fit(sweep.from_mm, cluster.ends);
    cluster.begins.beside_mm += goes_on_mm.value_or(0.0);
    cluster.ends = sweep.stands() ? cluster.begins : fit(sweep.to_mm, cluster.begins);
    const double beside = std::max(cluster.begins.beside_mm, cluster.ends.beside_mm);
    const double shrunk = std::abs(cluster.begins.turn.dot(cluster.ends.turn));
    return (sweep.reach_mm + 2.0 * beside) / shrunk;
}

void NeighbourPairs::take_shape(Cluster& cluster, std::span<const Vec3> positions_mm) {
    Vec3 centre = Vec3::Zero();
    for (const int v : cluster.nodes) centre += positions_mm[v];
    centre /= static_cast<double>(cluster.nodes.size());
    cluster.shape_mm.clear();
    for (const int v : cluster.nodes) cluster.shape_mm.push_back(positions_mm[v] - centre);
    cluster.begins = cluster.ends = {};
    cluster.known_to_mm = -1.0;
}

// Where the shape was taken.
void NeighbourPairs::search(Cluster& cluster, const Sweep& sweep) const {
    ++cluster.searches;
    cluster.known_to_mm = sweep.reach_mm + 2.0 * slack_mm_;
    std::vector<FeaturePair> near;
    sweep_all(cluster, {sweep.from_mm, sweep.from_mm, cluster.known_to_mm}, near);
    cluster.pairs.clear();
    for (const FeaturePair& pair : near) {
        const double apart = distance_mm(pair, sweep.from_mm);
        if (apart <= cluster.known_to_mm) cluster.pairs.push_back({apart, pair});
    }
    std::ranges::sort(cluster.pairs, {}, [](const Known& known) { return known.apart_mm; });
}

void NeighbourPairs::sweep_all(const Cluster& cluster, const Sweep& sweep,
                               std::vector<FeaturePair>& found) const {
    for (const int other : cluster.patches)
        search_.add_pairs_of(cluster.patches.front(), other, sweep, found);
}

void NeighbourPairs::add_along(Cluster& cluster, const Sweep& sweep,
                               std::optional<double> goes_on_mm,
                               std::vector<FeaturePair>& found) const {
    double needed = cluster.known_to_mm >= 0.0 ? needed_mm(cluster, sweep, goes_on_mm) : INFINITY;
    if (!(needed <= cluster.known_to_mm)) {
        take_shape(cluster, sweep.from_mm);
        needed = needed_mm(cluster, sweep, 0.0);
        if (!(needed <= sweep.reach_mm + 2.0 * slack_mm_)) {
            sweep_all(cluster, sweep, found);
            return;
        }
        search(cluster, sweep);
    }
    for (const Known& known : cluster.pairs) {
        if (known.apart_mm > needed) break;
        found.push_back(known.pair);
    }
}

void NeighbourPairs::add_along(const Sweep& sweep, std::optional<double> goes_on_mm,
                               std::vector<FeaturePair>& found) {
    const std::size_t blocks = (clusters_.size() + clusters_per_block - 1) / clusters_per_block;
    std::vector<std::vector<FeaturePair>> found_in(blocks);
    parallel_blocks(clusters_.size(), clusters_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c)
            add_along(clusters_[c], sweep, goes_on_mm, found_in[begin / clusters_per_block]);
    });
    for (const auto& some : found_in) found.insert(found.end(), some.begin(), some.end());
}

}  // namespace hepatica
