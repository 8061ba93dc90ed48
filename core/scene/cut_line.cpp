// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/cut_line.h"

#include <algorithm>
#include <map>
#include <optional>

#include "core/tree/station.h"

namespace hepatica {
namespace {

// Part of a segment, by arc length.
struct Stretch {
    double from_mm = 0.0;
    double to_mm = 0.0;
    double length_mm() const { return to_mm - from_mm; }
    double middle_mm() const { return 0.5 * (from_mm + to_mm); }
};

std::vector<int> ancestry(const VesselTree& tree, int segment) {
    std::vector<int> chain;
    for (int s = segment; s >= 0; s = tree.segments[s].parent) chain.push_back(s);
    return chain;
}

// The parts of the way along the tree, by segment.
std::map<int, Stretch> way_between(const VesselTree& tree, const TreePoint& from,
                                   const TreePoint& to) {
    std::map<int, Stretch> way;
    if (from.segment == to.segment) {
        way[from.segment] = {std::min(from.arclength_mm, to.arclength_mm),
                             std::max(from.arclength_mm, to.arclength_mm)};
        return way;
    }
    const std::vector<int> up = ancestry(tree, from.segment), down = ancestry(tree, to.segment);
    const auto meet = std::ranges::find_first_of(up, down);
    if (meet == up.end()) return way;
    const auto climb = [&](const TreePoint& end, const std::vector<int>& chain) {
        for (const int s : chain) {
            const double length = length_mm(tree.segments[s]);
            if (s == *meet) return;
            way[s] = {0.0, s == end.segment ? end.arclength_mm : length};
        }
    };
    climb(from, up);
    climb(to, down);
    // If one of the two is on the segment where the ways meet, the rest of that segment is on the
    // way.
    for (const TreePoint& end : {from, to})
        if (end.segment == *meet) way[*meet] = {end.arclength_mm, length_mm(tree.segments[*meet])};
    return way;
}

// A section across a vessel, between what lies before it and all that it feeds. Near a fork it runs
// between the branches, too. Vessels that touch farther away stay joined.
class Section {
  public:
    Section(const VesselTree& tree, int segment, double at_mm)
        : tree_(tree),
          segment_(segment),
          at_mm_(at_mm),
          station_(station_at(tree.segments[static_cast<std::size_t>(segment)], at_mm)) {}

    bool parts(const TreePoint& one, const TreePoint& other, const Vec3& between_mm) const {
        return beyond(one) != beyond(other) &&
               (between_mm - station_.position_mm).norm() <= reach_radii * station_.radius_mm;
    }

  private:
    static constexpr double reach_radii = 3.0;

    bool beyond(const TreePoint& place) const {
        if (place.segment == segment_) return place.arclength_mm >= at_mm_;
        int s = place.segment;
        while (s >= 0 && s != segment_) s = tree_.segments[static_cast<std::size_t>(s)].parent;
        return s == segment_;
    }

    const VesselTree& tree_;
    int segment_;
    double at_mm_;
    Station station_;
};

}  // namespace

std::vector<int> joints_along(const VesselTree& tree, std::span<const Joint> joints,
                              std::span<const VertexPlace> tetrahedra, const TreePoint& from,
                              const TreePoint& to, double section_mm) {
    const std::map<int, Stretch> way = way_between(tree, from, to);
    double length = 0.0;
    for (const auto& [segment, stretch] : way) length += stretch.length_mm();
    const bool section = way.size() == 1 && length < section_mm;
    const auto on_way = [&](const TreePoint& place) {
        const auto stretch = way.find(place.segment);
        return stretch != way.end() && place.arclength_mm >= stretch->second.from_mm &&
               place.arclength_mm <= stretch->second.to_mm;
    };
    std::optional<Section> across;
    if (section) across.emplace(tree, way.begin()->first, way.begin()->second.middle_mm());
    std::vector<int> found;
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const TreePoint& one = tetrahedra[joints[j].tetrahedra[0]].on_tree;
        const TreePoint& other = tetrahedra[joints[j].tetrahedra[1]].on_tree;
        if (across ? across->parts(one, other, joints[j].centre_mm) : on_way(one) && on_way(other))
            found.push_back(static_cast<int>(j));
    }
    return found;
}

BladeSweep blade_sweep(const Vec3& from_mm, const Vec3& to_mm, const Vec3& axis, double reach_mm) {
    const Vec3 way = to_mm - from_mm;
    Vec3 edge = way.cross(axis);
    if (!(edge.norm() > 1e-6 * way.norm() * axis.norm())) edge = way.unitOrthogonal();
    edge.normalize();
    return {from_mm - reach_mm * edge, way, 2.0 * reach_mm * edge};
}

}  // namespace hepatica
