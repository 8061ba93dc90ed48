// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/live_region.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace hepatica {
namespace {

constexpr std::size_t nodes_at_once = 256;

}  // namespace

LiveRegion::LiveRegion(const CoarseSkeleton& skeleton, std::span<const Vec3> rest_positions_mm,
                       const LiveRegionOptions& options)
    : skeleton_(skeleton), options_(options) {
    if (skeleton_.size() == 0) {
        throw InputError("the skeleton has no node", "live region",
                         "Make one with skeleton_of_mesh.");
    }
    validate(skeleton_);
    const SkeletonBinding binding = bind_vertices(skeleton_, rest_positions_mm);
    const std::size_t nodes = skeleton_.parent.size();
    vertices_of_.resize(nodes);
    neighbours_.resize(nodes);
    for (std::size_t v = 0; v < binding.nodes.size(); ++v) {
        const std::size_t nearer = binding.weights[v][1] > binding.weights[v][0] ? 1 : 0;
        node_of_.push_back(binding.nodes[v][nearer]);
        vertices_of_[node_of_[v]].push_back(static_cast<int>(v));
    }
    for (std::size_t n = 0; n < nodes; ++n) {
        const int parent = skeleton_.parent[n];
        if (parent < 0) continue;
        neighbours_[n].push_back(parent);
        neighbours_[parent].push_back(static_cast<int>(n));
    }
    reference_mm_.assign(rest_positions_mm.begin(), rest_positions_mm.end());
    wake_all();
}

void LiveRegion::connect(std::span<const int> vertices) {
    for (const int a : vertices) {
        for (const int b : vertices) {
            const int node = node_of_[a], other = node_of_[b];
            if (node == other) continue;
            auto& known = neighbours_[node];
            if (std::find(known.begin(), known.end(), other) == known.end()) known.push_back(other);
        }
    }
}

void LiveRegion::follow_split(std::span<const int> parents) {
    for (std::size_t v = node_of_.size(); v < parents.size(); ++v) {
        const int parent = parents[v];
        node_of_.push_back(int(node_of_[parent]));
        vertices_of_[node_of_[v]].push_back(static_cast<int>(v));
        reference_mm_.push_back(Vec3(reference_mm_[parent]));
    }
}

void LiveRegion::wake_all() {
    live_.assign(neighbours_.size(), 1);
    still_s_.assign(neighbours_.size(), 0.0);
}

int LiveRegion::live_count() const {
    return static_cast<int>(std::count(live_.begin(), live_.end(), 1));
}

bool LiveRegion::wake_around(std::span<const int> nodes) {
    std::vector<int> front(nodes.begin(), nodes.end()), next;
    std::vector<char> seen(live_.size(), 0);
    for (const int node : front) seen[node] = 1;
    bool woke = false;
    for (int distance = 0; distance <= options_.reach_nodes; ++distance) {
        next.clear();
        for (const int node : front) {
            woke |= live_[node] == 0;
            live_[node] = 1;
            still_s_[node] = 0.0;
            for (const int other : neighbours_[node]) {
                if (seen[other]) continue;
                seen[other] = 1;
                next.push_back(other);
            }
        }
        front.swap(next);
    }
    return woke;
}

bool LiveRegion::hold(std::span<const int> vertices) {
    held_.clear();
    for (const int v : vertices) held_.push_back(node_of_[v]);
    return wake_around(held_);
}

bool LiveRegion::borders_on_frozen(std::size_t node) const {
    return std::ranges::any_of(neighbours_[node], [&](int other) { return live_[other] == 0; });
}

std::vector<char> LiveRegion::nodes_at_borders() const {
    std::vector<char> bordered(live_.size());
    for (std::size_t n = 0; n < live_.size(); ++n) bordered[n] = borders_on_frozen(n) ? 1 : 0;
    return bordered;
}

// Stores reference positions for nodes that have just got their first frozen neighbour. Nodes that
// already had one keep the older reference, so that small changes of strain add up.
void LiveRegion::refer_to(std::span<const Vec3> positions_mm,
                          const std::vector<char>& bordered_before) {
    for (std::size_t n = 0; n < live_.size(); ++n) {
        if (bordered_before[n] || !borders_on_frozen(n)) continue;
        for (const int v : vertices_of_[n]) reference_mm_[v] = positions_mm[v];
    }
}

bool LiveRegion::wake(std::span<const int> vertices) {
    std::vector<int> nodes;
    for (const int v : vertices) nodes.push_back(node_of_[v]);
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return wake_around(nodes);
}

bool LiveRegion::watch(std::span<const Vec3> positions_mm,
                       std::span<const Vec3> velocities_mm_per_s, double dt_s) {
    std::vector<int> waking;
    std::vector<char> restless(live_.size(), 0), strained(live_.size(), 0);
    parallel_blocks(live_.size(), nodes_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) {
            if (!live_[n]) continue;
            const double radius = skeleton_.radii_mm[n];
            double fastest = 0.0, furthest = 0.0;
            for (const int v : vertices_of_[n]) {
                fastest = std::max(fastest, velocities_mm_per_s[v].squaredNorm());
                furthest = std::max(furthest, (positions_mm[v] - reference_mm_[v]).squaredNorm());
            }
            const double still = options_.still_radii_per_s * radius;
            still_s_[n] = fastest < still * still ? still_s_[n] + dt_s : 0.0;
            restless[n] = still_s_[n] < options_.still_s;
            const double moved = options_.wake_radii * radius;
            strained[n] = !(furthest < moved * moved);
        }
    });
    for (std::size_t n = 0; n < live_.size(); ++n)
        for (const int other : neighbours_[n])
            if (strained[n] != 0 && !live_[other]) waking.push_back(other);
    if (wake_around(waking)) {
        // Each growth costs a rebuild, so past half of the body everything is made live.
        if (2 * live_count() > static_cast<int>(live_.size())) wake_all();
        return true;
    }
    // Nodes that are held or still move stay live, and so do those around them.
    const std::vector<char> before = live_;
    const int count_before = live_count();
    const std::vector<char> bordered_before = nodes_at_borders();
    std::vector<int> keep = held_;
    for (std::size_t n = 0; n < restless.size(); ++n) {
        if (restless[n]) keep.push_back(static_cast<int>(n));
    }
    const std::vector<double> timers = still_s_;
    std::fill(live_.begin(), live_.end(), 0);
    wake_around(keep);
    for (std::size_t n = 0; n < live_.size(); ++n) live_[n] = live_[n] && before[n];
    still_s_ = timers;
    if (live_count() == count_before || 4 * live_count() > 3 * count_before) {
        live_ = before;
        return false;
    }
    refer_to(positions_mm, bordered_before);
    return true;
}

RegionCheckpoint LiveRegion::checkpoint() const {
    return {.live = {live_.begin(), live_.end()},
            .still_s = still_s_,
            .held = held_,
            .reference_mm = reference_mm_};
}

void LiveRegion::restore(const RegionCheckpoint& checkpoint) {
    const auto fits = [&](bool condition, const std::string& problem) {
        if (!condition)
            throw InputError(problem, "the checkpoint of a body",
                             "Make the stepper of the body that it was taken of");
    };
    const std::size_t nodes = live_.size();
    fits(checkpoint.live.size() == nodes && checkpoint.still_s.size() == nodes,
         "is of a skeleton of " + std::to_string(checkpoint.live.size()) + " nodes instead of " +
             std::to_string(nodes));
    fits(std::ranges::all_of(checkpoint.live, [](std::uint8_t live) { return live <= 1; }),
         "marks a skeleton node as neither live nor frozen");
    fits(std::ranges::all_of(checkpoint.held,
                             [&](int n) { return n >= 0 && static_cast<std::size_t>(n) < nodes; }),
         "holds a skeleton node that does not exist");
    fits(checkpoint.reference_mm.size() == node_of_.size(),
         "is of a body of " + std::to_string(checkpoint.reference_mm.size()) + " vertices");
    live_.assign(checkpoint.live.begin(), checkpoint.live.end());
    still_s_ = checkpoint.still_s;
    held_ = checkpoint.held;
    reference_mm_ = checkpoint.reference_mm;
}

}  // namespace hepatica
