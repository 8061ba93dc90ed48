// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest points on the centrelines of a tree for many queries, with the edges in a uniform grid of
// cells. nearest_point() in vessel_tree.h is the simple form for a single query.
#pragma once

#include <optional>
#include <vector>

#include "core/tree/vessel_tree.h"

namespace hepatica {

class CentrelineLocator {
  public:
    struct Nearest {
        int segment = -1;
        Vec3 position_mm = Vec3::Zero();
        double radius_mm = 0.0;    // of the lumen there
        double distance_mm = 0.0;  // from the query
    };

    // Copies what it needs of the tree.
    explicit CentrelineLocator(const VesselTree& tree);

    // None where no centreline lies within reach_mm. Thread-safe.
    std::optional<Nearest> nearest(const Vec3& position_mm, double reach_mm) const;

  private:
    struct Edge {
        Vec3 from, to;
        double from_radius_mm, to_radius_mm;
        int segment;
    };

    Index3 cell_of(const Vec3& position_mm) const;
    const std::vector<int>& cell(int x, int y, int z) const {
        return cells_[x + static_cast<std::size_t>(cell_counts_[0]) *
                              (y + static_cast<std::size_t>(cell_counts_[1]) * z)];
    }

    std::vector<Edge> edges_;
    Vec3 corner_mm_ = Vec3::Zero();
    double cell_mm_ = 1.0;
    Index3 cell_counts_{0, 0, 0};
    std::vector<std::vector<int>> cells_;
};

}  // namespace hepatica
