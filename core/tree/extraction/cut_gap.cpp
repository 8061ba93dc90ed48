// SPDX-License-Identifier: GPL-3.0-or-later
// Walks from the cut in both directions until balls of the lumen are clear of the walls on the
// other side.
#include "core/tree/extraction/cut_gap.h"

#include <algorithm>
#include <limits>

#include "core/tree/extraction/centreline.h"

namespace hepatica {

namespace {

constexpr double step_mm = 0.1;  // between the positions tried
constexpr double shortest_stump_mm = 0.5;
constexpr double fork_radii = 4.0;  // how far along its vessels the surroundings of a node extend

struct Ball {
    Vec3 centre_mm;
    double radius_mm;
};

using Wall = std::vector<Ball>;  // union of round cones between consecutive balls

// Distance from the ball to the wall; negative where they overlap.
double clearance_mm(const Ball& ball, const Wall& wall) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < wall.size(); ++i) {
        const Ball& from = wall[i - 1];
        const Vec3 edge = wall[i].centre_mm - from.centre_mm;
        const double length_squared = std::max(edge.squaredNorm(), 1e-300);
        const double share =
            std::clamp((ball.centre_mm - from.centre_mm).dot(edge) / length_squared, 0.0, 1.0);
        const double radius_mm = from.radius_mm + share * (wall[i].radius_mm - from.radius_mm);
        const double distance_mm = (from.centre_mm + share * edge - ball.centre_mm).norm();
        least = std::min(least, distance_mm - radius_mm - ball.radius_mm);
    }
    return least;
}

// The part of a link that counts as the surroundings of one of its nodes.
Wall wall_near(const VesselLink& link, bool at_from) {
    Wall wall;
    for (std::size_t i = 0; i < link.points_mm.size(); ++i)
        wall.push_back({link.points_mm[i], link.radii_mm[i]});
    if (!at_from) std::ranges::reverse(wall);
    const double reach_mm = fork_radii * wall.front().radius_mm;
    double along_mm = 0.0;
    std::size_t kept = 1;
    while (kept < wall.size() && along_mm < reach_mm) {
        along_mm += (wall[kept].centre_mm - wall[kept - 1].centre_mm).norm();
        ++kept;
    }
    wall.resize(kept);
    return wall;
}

bool is_clear_of(const Ball& ball, const std::vector<Wall>& walls) {
    return std::ranges::all_of(
        walls, [&](const Wall& wall) { return clearance_mm(ball, wall) >= cut_gap_mm; });
}

class Cutter {
  public:
    Cutter(const VesselGraph& graph, int link) : graph_(graph), link_(link) {
        const VesselLink& cut = graph.links[link];
        curve_ = resampled({cut.points_mm, cut.radii_mm}, step_mm);
        at_mm_ = arclengths_mm(curve_.points_mm);
    }

    std::optional<CutStretch> around(double along_mm) const {
        const std::size_t last = at_mm_.size() - 1;
        const std::size_t middle = std::min<std::size_t>(
            std::ranges::lower_bound(at_mm_, along_mm) - at_mm_.begin(), last);
        const Vec3 axis = tangents(curve_.points_mm, curve_.radii_mm[middle])[middle];
        const VesselLink& cut = graph_.links[link_];
        const std::vector<Wall> before = walls_at(cut.from), behind = walls_at(cut.to);
        // Without a stump, the part on a side ends at its node.
        for (const Wall& wall : before)
            if (!is_clear_of(wall.front(), behind)) return std::nullopt;
        for (const Wall& wall : behind)
            if (!is_clear_of(wall.front(), before)) return std::nullopt;
        CutStretch stretch;
        for (std::size_t i = middle + 1; i-- > 0 && !stretch.from_mm;)
            if (is_beyond(i, middle, -axis) && is_clear_of(ball(i), behind))
                stretch.from_mm = at_mm_[i];
        for (std::size_t i = middle; i <= last && !stretch.to_mm; ++i)
            if (is_beyond(i, middle, axis) && is_clear_of(ball(i), before))
                stretch.to_mm = at_mm_[i];
        if (stretch.from_mm < shortest_stump_mm) stretch.from_mm.reset();
        if (stretch.to_mm > at_mm_.back() - shortest_stump_mm) stretch.to_mm.reset();
        return stretch;
    }

  private:
    Ball ball(std::size_t i) const { return {curve_.points_mm[i], curve_.radii_mm[i]}; }

    // Whether the ball lies more than half the gap from the middle, in the direction `outward`.
    bool is_beyond(std::size_t i, std::size_t middle, const Vec3& outward) const {
        const double away_mm = (curve_.points_mm[i] - curve_.points_mm[middle]).dot(outward);
        return away_mm - curve_.radii_mm[i] >= 0.5 * cut_gap_mm;
    }

    // The walls of the other vessels at a node. Vessels that join both nodes of the link are left
    // out, because a cut of the link does not part them.
    std::vector<Wall> walls_at(int node) const {
        const VesselLink& cut = graph_.links[link_];
        const int other = cut.from == node ? cut.to : cut.from;
        std::vector<Wall> found;
        for (const VesselLink& l : graph_.links) {
            const bool here = l.from == node || l.to == node;
            const bool there = l.from == other || l.to == other;
            if (here && !there) found.push_back(wall_near(l, l.from == node));
        }
        return found;
    }

    const VesselGraph& graph_;
    int link_;
    Centreline curve_;
    std::vector<double> at_mm_;
};

}  // namespace

std::optional<CutStretch> cut_stretch(const VesselGraph& graph, int link, double along_mm) {
    return Cutter(graph, link).around(along_mm);
}

}  // namespace hepatica
