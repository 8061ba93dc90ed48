// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/systems/blob_removal.h"

#include <algorithm>

namespace hepatica {

namespace {

constexpr double least_radius_mm = 4.0;
constexpr double least_widening = 1.5;
constexpr double most_radii = 10.0;  // of length
constexpr double seed_reach_mm = 3.0;

// What a segment and all that hangs on it hold.
struct Subtree {
    double length_mm = 0.0;
    double radius_mm = 0.0;  // greatest
    bool seeded = false;
};

bool holds_seed(const VesselSegment& segment, const std::vector<VesselSeed>& seeds) {
    return std::ranges::any_of(seeds, [&](const VesselSeed& seed) {
        for (std::size_t i = 0; i < segment.points_mm.size(); ++i)
            if ((segment.points_mm[i] - seed.position_mm).norm() <
                std::max(seed_reach_mm, segment.radii_mm[i]))
                return true;
        return false;
    });
}

// Of each segment's descendants and of itself from its narrowest point on.
std::vector<Subtree> beyond_necks(const VesselTree& tree, const std::vector<VesselSeed>& seeds) {
    std::vector<Subtree> whole(tree.segments.size()), beyond(tree.segments.size());
    for (std::size_t i = tree.segments.size(); i-- > 0;) {
        const VesselSegment& s = tree.segments[i];
        const auto neck = std::ranges::min_element(s.radii_mm);
        beyond[i] = whole[i];  // so far that of its children
        beyond[i].radius_mm =
            std::max(beyond[i].radius_mm, *std::max_element(neck, s.radii_mm.end()));
        beyond[i].length_mm += length_mm(s);
        beyond[i].seeded = beyond[i].seeded || holds_seed(s, seeds);
        whole[i] = beyond[i];
        whole[i].radius_mm = std::max(whole[i].radius_mm, std::ranges::max(s.radii_mm));
        if (s.parent < 0) continue;
        Subtree& parent = whole[s.parent];
        parent.length_mm += whole[i].length_mm;
        parent.radius_mm = std::max(parent.radius_mm, whole[i].radius_mm);
        parent.seeded = parent.seeded || whole[i].seeded;
    }
    return beyond;
}

bool is_blob(const VesselSegment& segment, const Subtree& beyond) {
    const double neck_mm = std::ranges::min(segment.radii_mm);
    return segment.parent >= 0 && !beyond.seeded && beyond.radius_mm >= least_radius_mm &&
           beyond.radius_mm >= least_widening * neck_mm &&
           beyond.length_mm < most_radii * beyond.radius_mm;
}

}  // namespace

RemovedPieces remove_blobs(const VesselTree& tree, const std::vector<VesselSeed>& seeds,
                           VesselGraph& graph) {
    const std::vector<Subtree> beyond = beyond_necks(tree, seeds);
    RemovedPieces removed;
    std::vector<std::uint8_t> gone(tree.segments.size(), 0);
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
        const VesselSegment& s = tree.segments[i];
        const bool within = s.parent >= 0 && gone[s.parent] != 0;
        if (!within && !is_blob(s, beyond[i])) continue;
        gone[i] = 1;
        removed.count += !within;
        removed.length_mm += length_mm(s);
    }
    if (removed.count == 0) return removed;
    graph = to_graph(tree);
    remove_links(graph, gone);
    join_passing_nodes(graph);
    return removed;
}

}  // namespace hepatica
