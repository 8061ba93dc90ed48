// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/through_tears.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace hepatica {
namespace {

int most_common(const std::map<int, int>& counts) {
    return std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; })
        ->first;
}

double radius_at(const VesselSegment& segment, double arclength_mm) {
    double left = arclength_mm;
    for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
        left -= (segment.points_mm[i] - segment.points_mm[i - 1]).norm();
        if (left <= 0.0) return segment.radii_mm[i];
    }
    return segment.radii_mm.back();
}

}  // namespace

std::vector<ThroughTear> through_tears(const VesselTree& tree, const Tearing& tearing,
                                       std::span<const VertexPlace> tetrahedra, double stretch_mm) {
    std::vector<ThroughTear> found;
    if (tearing.report().vertices_split == 0) return found;
    const std::vector<int> piece = tearing.topology().piece_of_vertices(tearing.bound_pairs());
    // Pieces in each section of each segment; sections without tetrahedra are missing.
    std::vector<std::map<int, std::map<int, int>>> along(tree.segments.size());
    for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
        const TreePoint& at = tetrahedra[t].on_tree;
        ++along[at.segment][static_cast<int>(at.arclength_mm / stretch_mm)]
               [piece[tearing.topology().tetrahedra()[t][0]]];
    }
    const auto add = [&](int s, double arclength_mm) {
        const double radius = radius_at(tree.segments[s], arclength_mm);
        found.push_back({{s, arclength_mm, 0.0}, std::numbers::pi * radius * radius});
    };
    // Meshes of several systems are separate pieces from the start, but no segment is in two.
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        int before = -1;
        const int parent = tree.segments[s].parent;
        if (parent >= 0 && !along[parent].empty())
            before = most_common(along[parent].rbegin()->second);
        for (const auto& [stretch, counts] : along[s]) {
            const int now = most_common(counts);
            if (before >= 0 && now != before)
                add(static_cast<int>(s), std::max(0.0, stretch * stretch_mm));
            before = now;
        }
    }
    return found;
}

}  // namespace hepatica
