// SPDX-License-Identifier: GPL-3.0-or-later
// Which vessel each vertex of the body belongs to, and what lies downstream of a point: what a
// virtual injection lights up.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/base/vector.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Read-only after construction; any thread.
class SurfaceAnatomy {
  public:
    SurfaceAnatomy() = default;  // of nothing
    // `rest_positions_mm`: the body's vertices, undeformed. Throws InputError if the tree is empty,
    // Cancelled.
    SurfaceAnatomy(const VesselTree& tree, std::span<const Vec3> rest_positions_mm, Job& job);

    // Per vertex; what no index finds is a point of segment -1.
    TreePoint tree_point(int vertex) const;
    std::vector<VascularSystem> vertex_systems() const;

    // 1 for the vertices downstream of `from` (its own segment from there on, and all that branches
    // off later), else 0.
    std::vector<std::uint8_t> downstream_of(const TreePoint& from) const;
    // 1 for the vertices of this segment of the tree, else 0.
    std::vector<std::uint8_t> vertices_of(int segment) const;
    // Terminal branches in that territory, in the tree it belongs to, and in the whole system,
    // which may have several trees.
    int ends_downstream_of(int segment) const;
    int ends_in_tree_of(int segment) const;
    int ends_in_system_of(int segment) const;

    VascularSystem system_of(int segment) const;

    // For the user: where on its branch a point is, what lies downstream of it, and its share of
    // the flow through the root of its tree (per segment; may be empty). Empty for segment -1.
    std::string describe(const TreePoint& point, std::span<const double> flow_shares) const;

  private:
    std::vector<TreePoint> points_;       // per vertex
    std::vector<int> parent_;             // per segment
    std::vector<VascularSystem> system_;  // per segment
    std::vector<double> length_mm_;       // per segment
    std::vector<int> ends_;               // per segment: ends of the tree downstream of it
    std::vector<int> root_;               // per segment: the root of its tree
};

}  // namespace hepatica
