// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the vessel at a position and fits the reference line by least squares.
#include "core/tree/lumen_calibre.h"

#include <Eigen/Dense>
#include <algorithm>
#include <utility>

#include "core/base/median.h"
#include "core/tree/station.h"

namespace hepatica {
namespace {

constexpr int stations_a_side = 21;
// A vessel goes on past a side branch where its median radius, which a stenosis hardly changes,
// stays this share of what it was. By Murray's law (r^3 adds up) the branch then has two thirds of
// the radius at most.
constexpr double same_vessel = 0.9;

bool goes_on(const VesselSegment& a, const VesselSegment& b) {
    const auto [least, most] = std::minmax({median(a.radii_mm), median(b.radii_mm)});
    return least >= same_vessel * most;
}

void append(const VesselSegment& more, VesselSegment& vessel) {
    vessel.points_mm.insert(vessel.points_mm.end(), more.points_mm.begin() + 1,
                            more.points_mm.end());
    vessel.radii_mm.insert(vessel.radii_mm.end(), more.radii_mm.begin() + 1, more.radii_mm.end());
}

// A segment with as much of the same vessel on both sides as the reference needs. `at_mm`: the
// place along the segment, then along the whole.
VesselSegment through_side_branches(const VesselTree& tree, int segment, double far_mm,
                                    double& at_mm) {
    const auto& all = tree.segments;
    VesselSegment vessel = all[static_cast<std::size_t>(segment)];
    for (int up = vessel.parent, below = segment; up >= 0 && at_mm < far_mm;) {
        const VesselSegment& parent = all[static_cast<std::size_t>(up)];
        if (!goes_on(parent, all[static_cast<std::size_t>(below)])) break;
        VesselSegment longer = parent;
        append(vessel, longer);
        vessel = std::move(longer);
        at_mm += length_mm(parent);
        below = std::exchange(up, parent.parent);
    }
    for (int last = segment; length_mm(vessel) < at_mm + far_mm;) {
        int widest = -1;
        for (std::size_t s = 0; s < all.size(); ++s) {
            if (all[s].parent != last || all[s].closes_loop) continue;
            if (widest < 0 ||
                median(all[s].radii_mm) > median(all[static_cast<std::size_t>(widest)].radii_mm))
                widest = static_cast<int>(s);
        }
        if (widest < 0) break;
        const VesselSegment& child = all[static_cast<std::size_t>(widest)];
        if (!goes_on(all[static_cast<std::size_t>(last)], child)) break;
        append(child, vessel);
        last = widest;
    }
    return vessel;
}

// The reference diameter at `place_mm`: value of the least-squares line through the diameters
// beside it.
std::optional<double> reference_at(const VesselSegment& segment, double place_mm, double near_mm,
                                   double far_mm) {
    const double length = length_mm(segment), step = (far_mm - near_mm) / (stations_a_side - 1);
    Eigen::Matrix2d sums = Eigen::Matrix2d::Zero();
    Eigen::Vector2d moments = Eigen::Vector2d::Zero();
    for (const double side : {-1.0, 1.0}) {
        int found = 0;
        for (int k = 0; k < stations_a_side; ++k) {
            const double offset = side * (near_mm + k * step);
            if (place_mm + offset < 0.0 || place_mm + offset > length) continue;
            const Eigen::Vector2d row(1.0, offset);
            sums += row * row.transpose();
            moments += 2.0 * station_at(segment, place_mm + offset).radius_mm * row;
            ++found;
        }
        if (2 * found < stations_a_side) return std::nullopt;
    }
    const double reference = Eigen::Vector2d(sums.ldlt().solve(moments)).x();
    return reference > 0.0 ? std::optional(reference) : std::nullopt;
}

}  // namespace

std::optional<LumenCalibre> calibre_at(const VesselTree& tree, const Vec3& position_mm,
                                       double margin_mm, double near_mm, double far_mm) {
    // Score: distance outside the wall in mm; inside the lumen, distance from the axis in radii
    // minus 1.
    double best = margin_mm;
    std::optional<LumenCalibre> found;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const NearestStation place = nearest_station(tree.segments[s], position_mm);
        const Station here = station_at(tree.segments[s], place.arclength_mm);
        const double beyond_mm = place.distance_mm - here.radius_mm;
        const double score = beyond_mm < 0.0 ? beyond_mm / here.radius_mm : beyond_mm;
        if (score > best || (found && score == best)) continue;
        best = score;
        found = {static_cast<int>(s),
                 place.arclength_mm,
                 here.position_mm,
                 2.0 * here.radius_mm,
                 {},
                 {}};
    }
    if (!found) return std::nullopt;
    LumenCalibre& calibre = *found;
    double at_mm = calibre.arclength_mm;
    const VesselSegment vessel = through_side_branches(tree, calibre.segment, far_mm, at_mm);
    calibre.reference_mm = reference_at(vessel, at_mm, near_mm, far_mm);
    if (calibre.reference_mm) calibre.stenosis = 1.0 - calibre.diameter_mm / *calibre.reference_mm;
    return found;
}

}  // namespace hepatica
