// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the vessel at a position and fits the reference line by least squares.
#include "core/tree/lumen_calibre.h"

#include <Eigen/Dense>

#include "core/tree/station.h"

namespace hepatica {
namespace {

constexpr int stations_a_side = 21;

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
    const VesselSegment& segment = tree.segments[static_cast<std::size_t>(calibre.segment)];
    calibre.reference_mm = reference_at(segment, calibre.arclength_mm, near_mm, far_mm);
    if (calibre.reference_mm) calibre.stenosis = 1.0 - calibre.diameter_mm / *calibre.reference_mm;
    return found;
}

}  // namespace hepatica
