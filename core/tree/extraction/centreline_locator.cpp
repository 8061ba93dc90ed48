// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts edges into at most 64 cells per axis, and searches growing neighbourhoods of the query.
#include "core/tree/extraction/centreline_locator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hepatica {

namespace {

constexpr int most_cells_per_axis = 64;

}  // namespace

CentrelineLocator::CentrelineLocator(const VesselTree& tree) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
            edges_.push_back({segment.points_mm[i - 1], segment.points_mm[i],
                              segment.radii_mm[i - 1], segment.radii_mm[i], static_cast<int>(s)});
            low = low.cwiseMin(segment.points_mm[i - 1]).cwiseMin(segment.points_mm[i]);
            high = high.cwiseMax(segment.points_mm[i - 1]).cwiseMax(segment.points_mm[i]);
        }
    }
    if (edges_.empty()) return;
    corner_mm_ = low;
    cell_mm_ = std::max((high - low).maxCoeff() / most_cells_per_axis, 1e-3);
    for (int a = 0; a < 3; ++a)
        cell_counts_[a] = static_cast<int>((high[a] - low[a]) / cell_mm_) + 1;
    cells_.resize(static_cast<std::size_t>(cell_counts_[0]) * cell_counts_[1] *
                  static_cast<std::size_t>(cell_counts_[2]));
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const Index3 from = cell_of(edges_[e].from.cwiseMin(edges_[e].to));
        const Index3 to = cell_of(edges_[e].from.cwiseMax(edges_[e].to));
        for (int z = from[2]; z <= to[2]; ++z)
            for (int y = from[1]; y <= to[1]; ++y)
                for (int x = from[0]; x <= to[0]; ++x)
                    cells_[x + static_cast<std::size_t>(cell_counts_[0]) *
                                   (y + static_cast<std::size_t>(cell_counts_[1]) * z)]
                        .push_back(static_cast<int>(e));
    }
}

Index3 CentrelineLocator::cell_of(const Vec3& position_mm) const {
    Index3 index{};
    for (int a = 0; a < 3; ++a)
        index[a] = static_cast<int>(std::clamp((position_mm[a] - corner_mm_[a]) / cell_mm_, 0.0,
                                               static_cast<double>(cell_counts_[a] - 1)));
    return index;
}

std::optional<CentrelineLocator::Nearest> CentrelineLocator::nearest(const Vec3& position_mm,
                                                                     double reach_mm) const {
    if (edges_.empty()) return std::nullopt;
    const auto reaches = [&](double within_mm) -> std::optional<Nearest> {
        const Index3 low = cell_of(position_mm - Vec3::Constant(within_mm));
        const Index3 high = cell_of(position_mm + Vec3::Constant(within_mm));
        Nearest best;
        best.distance_mm = within_mm;
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int x = low[0]; x <= high[0]; ++x)
                    for (const int e : cell(x, y, z)) {
                        const Edge& edge = edges_[e];
                        const Vec3 along = edge.to - edge.from;
                        const double share = std::clamp(
                            (position_mm - edge.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
                        const Vec3 at = edge.from + share * along;
                        const double distance = (at - position_mm).norm();
                        if (distance > best.distance_mm ||
                            (distance == best.distance_mm && best.segment >= 0))
                            continue;
                        best = {
                            edge.segment, at,
                            edge.from_radius_mm + share * (edge.to_radius_mm - edge.from_radius_mm),
                            distance};
                    }
        return best.segment < 0 ? std::nullopt : std::optional(best);
    };
    // Most queries find something nearby; only the others search many cells.
    for (double within = std::min(cell_mm_, reach_mm);; within = std::min(3.0 * within, reach_mm))
        if (const auto found = reaches(within); found || within >= reach_mm) return found;
}

}  // namespace hepatica
