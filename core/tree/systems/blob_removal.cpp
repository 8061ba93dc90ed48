// SPDX-License-Identifier: GPL-3.0-or-later
// Measures boxes and radii of subtrees from the ends to the roots, and removes those shaped like
// blobs.
#include "core/tree/systems/blob_removal.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

namespace hepatica {

namespace {

constexpr double least_radius_mm = 4.0;
constexpr double least_widening = 1.5;
constexpr double most_radii = 10.0;  // largest diagonal in radii
// The same for a separate tree, which has no neck and may be the cut-off trunk of a vein.
constexpr double most_radii_apart = 6.0;
constexpr double seed_reach_mm = 3.0;

// Extent of a part of the tree.
struct Subtree {
    Eigen::AlignedBox3d box_mm;
    double radius_mm = 0.0;  // largest
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

// Both for each segment.
struct Subtrees {
    std::vector<Subtree> whole;   // the segment and its descendants
    std::vector<Subtree> beyond;  // its descendants, and itself from its narrowest point on
};

Subtrees subtrees_of(const VesselTree& tree, const std::vector<VesselSeed>& seeds) {
    Subtrees subtrees{std::vector<Subtree>(tree.segments.size()),
                      std::vector<Subtree>(tree.segments.size())};
    auto& [whole, beyond] = subtrees;
    for (std::size_t i = tree.segments.size(); i-- > 0;) {
        const VesselSegment& s = tree.segments[i];
        const auto neck = std::ranges::min_element(s.radii_mm);
        beyond[i] = whole[i];  // so far only its children
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
    return subtrees;
}

bool is_blob(const VesselSegment& segment, const Subtree& beyond) {
    const double neck_mm = std::ranges::min(segment.radii_mm);
    return segment.parent >= 0 && !beyond.seeded && beyond.radius_mm >= least_radius_mm &&
           beyond.radius_mm >= least_widening * neck_mm &&
           beyond.box_mm.diagonal().norm() < most_radii * beyond.radius_mm;
}

// Marks the root segments of trees other than the longest one of their system.
std::vector<std::uint8_t> apart_from_main_tree(const VesselTree& tree) {
    std::vector<double> below_mm(tree.segments.size(), 0.0);
    for (std::size_t i = tree.segments.size(); i-- > 0;) {
        below_mm[i] += length_mm(tree.segments[i]);
        if (tree.segments[i].parent >= 0) below_mm[tree.segments[i].parent] += below_mm[i];
    }
    const std::vector<int> all = roots(tree);
    std::map<VascularSystem, double> longest_mm;
    for (const int root : all) {
        double& longest = longest_mm[tree.segments[root].system];
        longest = std::max(longest, below_mm[root]);
    }
    std::vector<std::uint8_t> apart(tree.segments.size(), 0);
    for (const int root : all)
        apart[root] = below_mm[root] < longest_mm[tree.segments[root].system];
    return apart;
}

bool is_blob_apart(const Subtree& whole) {
    return !whole.seeded && whole.radius_mm >= least_radius_mm &&
           whole.box_mm.diagonal().norm() < most_radii_apart * whole.radius_mm;
}

// Ends a link of the tree's graph at its neck; false, with no change, where the neck is its first
// point.
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
    const Subtrees subtrees = subtrees_of(tree, seeds);
    const std::vector<std::uint8_t> apart = apart_from_main_tree(tree);
    RemovedPieces removed;
    VesselGraph kept = to_graph(tree);
    std::vector<std::uint8_t> hangs_on_blob(tree.segments.size(), 0), gone = hangs_on_blob;
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
        const VesselSegment& s = tree.segments[i];
        const bool within = s.parent >= 0 && hangs_on_blob[s.parent] != 0;
        const bool stands_apart = apart[i] != 0 && is_blob_apart(subtrees.whole[i]);
        if (!within && !stands_apart && !is_blob(s, subtrees.beyond[i])) continue;
        hangs_on_blob[i] = 1;
        gone[i] = within || stands_apart || !end_at_neck(kept, static_cast<int>(i));
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
