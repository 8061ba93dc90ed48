// SPDX-License-Identifier: GPL-3.0-or-later
// Searches paths from all open ends in parallel, scores them, and builds the confident ones
// greedily.
#include "core/tree/extraction/gap_bridging.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "core/base/disjoint_sets.h"
#include "core/base/median.h"
#include "core/base/parallel.h"
#include "core/image/interpolation.h"
#include "core/tree/extraction/centreline.h"
#include "core/tree/extraction/gap_paths.h"
#include "core/tree/extraction/lumen_measurement.h"

namespace hepatica {

namespace {

// Assigns the mask's 26-connected components to the pieces of the graph that lie in them.
class Pieces {
  public:
    Pieces(const VesselGraph& graph, const Mask& vessels)
        : mask_(vessels), of_node_(component_of_nodes(graph)), label_(vessels.grid, -1) {
        count_ = of_node_.empty() ? 0 : *std::ranges::max_element(of_node_) + 1;
        for (const VesselLink& link : graph.links)
            for (const Vec3& p : link.points_mm) fill(p, of_node_[link.from]);
    }

    int count() const { return count_; }
    int of_node(int node) const { return of_node_[node]; }
    int of_voxel(std::size_t offset) const { return label_.voxels[offset]; }

    Index3 voxel_at(const Vec3& position_mm) const {
        return nearest_voxel(mask_.grid, position_mm);
    }

  private:
    void fill(const Vec3& seed_mm, int piece) {
        const auto [sx, sy, sz] = voxel_at(seed_mm);
        const std::size_t start = mask_.grid.offset(sx, sy, sz);
        if (mask_.voxels[start] == 0 || label_.voxels[start] >= 0) return;
        std::vector<std::size_t> open{start};
        label_.voxels[start] = piece;
        while (!open.empty()) {
            const auto [x, y, z] = mask_.grid.index_of(open.back());
            open.pop_back();
            for (int dz = -1; dz <= 1; ++dz)
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        if (!mask_.grid.contains(x + dx, y + dy, z + dz)) continue;
                        const std::size_t q = mask_.grid.offset(x + dx, y + dy, z + dz);
                        if (mask_.voxels[q] == 0 || label_.voxels[q] >= 0) continue;
                        label_.voxels[q] = piece;
                        open.push_back(q);
                    }
        }
    }

    const Mask& mask_;
    std::vector<int> of_node_;
    Image<int> label_;
    int count_ = 0;
};

// Brightness of the CT between the parenchyma (0) and the vessels of the graph (1).
class Brightness {
  public:
    Brightness(const VesselGraph& graph, const Mask& vessels, const Volume* ct) : ct_(ct) {
        if (ct == nullptr) return;
        const double voxel_mm = vessels.grid.spacing_mm.maxCoeff();
        std::vector<double> inside, around;
        for (const VesselLink& link : graph.links)
            for (std::size_t i = 0; i < link.points_mm.size(); ++i) {
                inside.push_back(interpolate(*ct, link.points_mm[i]));
                for (const Vec3& p : places_beside(link.points_mm[i], link.radii_mm[i], voxel_mm))
                    if (interpolate(vessels, p) < 0.01) around.push_back(interpolate(*ct, p));
            }
        if (inside.size() < 10 || around.size() < 10) {
            ct_ = nullptr;
            return;
        }
        vessel_hu_ = median(std::move(inside));
        parenchyma_hu_ = median(std::move(around));
        if (vessel_hu_ - parenchyma_hu_ < 15.0) ct_ = nullptr;
    }

    bool known() const { return ct_ != nullptr; }
    double at(const Vec3& position_mm) const {
        if (ct_ == nullptr) return 0.0;
        const double hu = interpolate(*ct_, position_mm);
        return std::clamp((hu - parenchyma_hu_) / (vessel_hu_ - parenchyma_hu_), 0.0, 1.0);
    }

  private:
    const Volume* ct_;
    double vessel_hu_ = 0.0;
    double parenchyma_hu_ = 0.0;
};

struct Candidate {
    int from_node;
    int from_piece;
    int to_piece;
    Bridge bridge;
};

class Bridging {
  public:
    Bridging(VesselGraph& graph, const Mask& vessels, const Volume* ct,
             const BridgeOptions& options, const std::function<void(double)>& progress)
        : graph_(graph),
          options_(options),
          progress_(progress),
          pieces_(graph, vessels),
          brightness_(graph, vessels, ct),
          grid_(vessels.grid),
          widest_mm_(pieces_.count(), 0.0) {
        for (const VesselLink& link : graph.links)
            for (const double r : link.radii_mm) {
                double& widest = widest_mm_[pieces_.of_node(link.from)];
                widest = std::max(widest, r);
            }
    }

    std::vector<Bridge> run() {
        if (pieces_.count() < 2) return {};
        std::vector<Candidate> candidates = find_candidates();
        std::ranges::stable_sort(candidates, std::greater<>(), [](const Candidate& c) {
            return std::tuple(c.bridge.confidence, -c.bridge.gap_mm);
        });
        DisjointSets joined(static_cast<std::size_t>(pieces_.count()));
        std::set<std::pair<std::uint32_t, std::uint32_t>> offered;
        std::vector<Bridge> bridges;
        for (Candidate& candidate : candidates) {
            const std::uint32_t a = joined.root(static_cast<std::uint32_t>(candidate.from_piece));
            const std::uint32_t b = joined.root(static_cast<std::uint32_t>(candidate.to_piece));
            if (a == b) continue;
            if (candidate.bridge.confidence >= options_.confidence) {
                progress_(1.0);  // allows cancelling
                joined.unite(a, b);
                build(candidate);
            } else if (!offered.insert(std::minmax(a, b)).second) {
                continue;
            }
            bridges.push_back(candidate.bridge);
        }
        join_passing_nodes(graph_);
        return bridges;
    }

  private:
    std::vector<Candidate> find_candidates() {
        const auto at_node = links_of_nodes(graph_);
        std::vector<int> ends;
        for (std::size_t n = 0; n < at_node.size(); ++n) {
            if (at_node[n].size() != 1) continue;
            progress_(0.0);  // allows cancelling: each end looks at all points
            if (others_in_reach(static_cast<int>(n))) ends.push_back(static_cast<int>(n));
        }
        std::vector<std::vector<Candidate>> found(ends.size());
        const GapSearch search{&grid_, [&](std::size_t p) { return pieces_.of_voxel(p); },
                               [&](const Vec3& p) { return brightness_.at(p); },
                               options_.longest_gap_mm};
        parallel_blocks(ends.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                progress_(ends_done_++ / static_cast<double>(ends.size()));
                const int node = ends[i];
                const int piece = pieces_.of_node(node);
                const Index3 start = pieces_.voxel_at(graph_.nodes[node].position_mm);
                for (const GapPath& path : gap_paths(search, piece, start))
                    found[i].push_back(judged(node, piece, at_node[node][0], path));
            }
        });
        std::vector<Candidate> all;
        for (auto& list : found) std::ranges::move(list, std::back_inserter(all));
        return all;
    }

    // Whether another piece's wall may lie within the longest gap from a node.
    bool others_in_reach(int node) const {
        for (const VesselLink& link : graph_.links) {
            if (pieces_.of_node(link.from) == pieces_.of_node(node)) continue;
            for (std::size_t i = 0; i < link.points_mm.size(); ++i)
                if ((link.points_mm[i] - graph_.nodes[node].position_mm).norm() <=
                    options_.longest_gap_mm + 2.0 * link.radii_mm[i])
                    return true;
        }
        return false;
    }

    Candidate judged(int node, int piece, int link_id, const GapPath& path) const {
        Candidate candidate{node, piece, path.piece, {}};
        Bridge& bridge = candidate.bridge;
        bridge.gap_mm = path.gap_mm;
        bridge.path_mm = path.points_mm;
        const VesselLink& link = graph_.links[link_id];
        bridge.from_radius_mm = link.from == node ? link.radii_mm.front() : link.radii_mm.back();
        const auto [target_link, target] = nearest_on_piece(path.piece, path.points_mm.back());
        const VesselLink& other = graph_.links[target_link];
        bridge.path_mm.push_back(other.points_mm[target]);
        bridge.to_radius_mm = other.radii_mm[target];
        bridge.confidence = brightness_share(path) * straightness(link, node, bridge) *
                            leads_to_wide_end(candidate);
        return candidate;
    }

    // Nearest point of a piece's centrelines: link and index of the point.
    std::pair<int, std::size_t> nearest_on_piece(int piece, const Vec3& position_mm) const {
        std::pair<int, std::size_t> best{-1, 0};
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t id = 0; id < graph_.links.size(); ++id) {
            const VesselLink& link = graph_.links[id];
            if (pieces_.of_node(link.from) != piece) continue;
            for (std::size_t i = 0; i < link.points_mm.size(); ++i) {
                const double d = (link.points_mm[i] - position_mm).squaredNorm();
                if (d >= least) continue;
                least = d;
                best = {static_cast<int>(id), i};
            }
        }
        return best;
    }

    // Mean brightness of the gap; without a usable CT, nearness decides.
    double brightness_share(const GapPath& path) const {
        if (!brightness_.known()) return std::exp(-path.gap_mm / 3.0);
        double sum = 0.0, count = 0.0;
        for (std::size_t i = 0; i < path.brightness.size(); ++i) {
            if (path.brightness[i] >= 1.0) continue;
            sum += path.brightness[i];
            count += 1.0;
        }
        const double mean = count > 0.0 ? sum / count : 1.0;
        // Noise alone makes dark gaps of a voxel or two.
        return std::max(mean, std::exp(-path.gap_mm / 1.5));
    }

    // 1 where the path continues in the direction of the vessel, down to 0.25 where it turns back.
    double straightness(const VesselLink& link, int node, const Bridge& bridge) const {
        std::vector<Vec3> points = link.points_mm;
        if (link.from == node) std::ranges::reverse(points);
        const double reach = 2.0 * bridge.from_radius_mm + 3.0 * grid_.spacing_mm.maxCoeff();
        Vec3 behind = points.front();
        for (std::size_t i = points.size(); i-- > 0;) {
            behind = points[i];
            if ((points[i] - points.back()).norm() > reach) break;
        }
        const Vec3 forward = (points.back() - behind).normalized();
        const Vec3 ahead = (bridge.path_mm.back() - points.back()).normalized();
        return std::clamp(0.75 + 0.5 * forward.dot(ahead), 0.0, 1.0);
    }

    double leads_to_wide_end(const Candidate& c) const {
        const double from = c.bridge.from_radius_mm / widest_mm_[c.from_piece];
        const double to = c.bridge.to_radius_mm / widest_mm_[c.to_piece];
        return std::min(1.0, std::max(from, to) / 0.6);
    }

    void build(Candidate& candidate) {
        Bridge& bridge = candidate.bridge;
        bridge.built = true;
        // An earlier bridge may have split the target's link, so it is looked up again.
        VesselGraph& graph = graph_;
        int nearest = -1;
        std::size_t at = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t id = 0; id < graph.links.size() && least > 0.0; ++id)
            for (std::size_t i = 0; i < graph.links[id].points_mm.size(); ++i) {
                const double d =
                    (graph.links[id].points_mm[i] - bridge.path_mm.back()).squaredNorm();
                if (d >= least) continue;
                least = d;
                nearest = static_cast<int>(id);
                at = i;
            }
        const double along = arclengths_mm(graph.links[nearest].points_mm)[at];
        const int to = split_link(graph, nearest, along, bridge.to_radius_mm);
        VesselLink link;
        link.from = candidate.from_node;
        link.to = to;
        link.system = graph.links[nearest].system;
        std::vector<Vec3> points = bridge.path_mm;
        points.front() = graph.nodes[link.from].position_mm;
        points.back() = graph.nodes[to].position_mm;
        const double voxel_mm = std::cbrt(grid_.spacing_mm.prod());
        points = smooth_curve(points, 2.0 * voxel_mm, true);
        const double narrow = std::min(bridge.from_radius_mm, bridge.to_radius_mm);
        Centreline even = resampled({points, std::vector<double>(points.size(), narrow)}, voxel_mm);
        for (std::size_t i = 0; i < even.radii_mm.size(); ++i) {
            const double share =
                static_cast<double>(i) / static_cast<double>(even.radii_mm.size() - 1);
            even.radii_mm[i] = bridge.from_radius_mm + share * (narrow - bridge.from_radius_mm);
        }
        link.points_mm = even.points_mm;
        link.radii_mm = even.radii_mm;
        bridge.path_mm = even.points_mm;
        graph.links.push_back(std::move(link));
    }

    VesselGraph& graph_;
    const BridgeOptions& options_;
    const std::function<void(double)>& progress_;
    std::atomic<int> ends_done_ = 0;
    Pieces pieces_;
    Brightness brightness_;
    Grid grid_;
    std::vector<double> widest_mm_;
};

}  // namespace

std::vector<Bridge> bridge_gaps(VesselGraph& graph, const Mask& vessels, const Volume* ct,
                                const BridgeOptions& options,
                                const std::function<void(double)>& progress) {
    return Bridging(graph, vessels, ct, options, progress).run();
}

}  // namespace hepatica
