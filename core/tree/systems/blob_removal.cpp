// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/systems/blob_removal.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace hepatica {

namespace {

constexpr double least_radius_mm = 4.0;
constexpr double least_widening = 1.5;
constexpr double most_radii = 10.0;  // across
constexpr double seed_reach_mm = 3.0;

// What a segment and all that hangs on it hold.
struct Subtree {
    Eigen::AlignedBox3d box_mm;
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
        for (auto p = neck - s.radii_mm.begin(); p < std::ssize(s.points_mm); ++p)
            beyond[i].box_mm.extend(s.points_mm[p]);
        beyond[i].seeded = beyond[i].seeded || holds_seed(s, seeds);
        whole[i] = beyond[i];
        whole[i].radius_mm = std::max(whole[i].radius_mm, std::ranges::max(s.radii_mm));
        for (const Vec3& point : s.points_mm) whole[i].box_mm.extend(point);
        if (s.parent < 0) continue;
        Subtree& parent = whole[s.parent];
        parent.box_mm.extend(whole[i].box_mm);
        parent.radius_mm = std::max(parent.radius_mm, whole[i].radius_mm);
        parent.seeded = parent.seeded || whole[i].seeded;
    }
    return beyond;
}

bool is_blob(const VesselSegment& segment, const Subtree& beyond) {
    const double neck_mm = std::ranges::min(segment.radii_mm);
    return segment.parent >= 0 && !beyond.seeded && beyond.radius_mm >= least_radius_mm &&
           beyond.radius_mm >= least_widening * neck_mm &&
           beyond.box_mm.diagonal().norm() < most_radii * beyond.radius_mm;
}

// Cuts a link of the tree's graph off at its neck; false, and nothing changed, where that is at its
// beginning.
bool end_at_neck(VesselGraph& graph, int id) {
    VesselLink& link = graph.links[id];
    const auto neck = std::ranges::min_element(link.radii_mm) - link.radii_mm.begin();
    if (neck < 1) return false;
    link.points_mm.resize(neck + 1);
    link.radii_mm.resize(neck + 1);
    link.to = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back({link.points_mm.back(), link.radii_mm.back()});
    return true;
}

}  // namespace

RemovedPieces remove_blobs(const VesselTree& tree, const std::vector<VesselSeed>& seeds,
                           VesselGraph& graph) {
    const std::vector<Subtree> beyond = beyond_necks(tree, seeds);
    RemovedPieces removed;
    VesselGraph kept = to_graph(tree);
    std::vector<std::uint8_t> hangs_on_blob(tree.segments.size(), 0), gone = hangs_on_blob;
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
        const VesselSegment& s = tree.segments[i];
        const bool within = s.parent >= 0 && hangs_on_blob[s.parent] != 0;
        if (!within && !is_blob(s, beyond[i])) continue;
        hangs_on_blob[i] = 1;
        gone[i] = within || !end_at_neck(kept, static_cast<int>(i));
        removed.count += !within;
        removed.length_mm += length_mm(s) - (gone[i] != 0 ? 0.0 : length_mm(kept.links[i]));
    }
    if (removed.count == 0) return removed;
    remove_links(kept, gone);
    join_passing_nodes(kept);
    graph = std::move(kept);
    return removed;
}

}  // namespace hepatica
