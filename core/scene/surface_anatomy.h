// SPDX-License-Identifier: GPL-3.0-or-later
// Which vessel each vertex of the body belongs to, and what lies downstream of a point, for showing
// a virtual injection.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/base/vector.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// Read-only after construction; thread-safe.
class SurfaceAnatomy {
  public:
    SurfaceAnatomy() = default;  // empty
    // `rest_positions_mm`: the body's vertices, undeformed. Throws InputError if the tree is empty,
    // and Cancelled.
    SurfaceAnatomy(const VesselTree& tree, std::span<const Vec3> rest_positions_mm, Job& job);

    // The point on the tree of a vertex; segment -1 for an invalid index.
    TreePoint tree_point(int vertex) const;
    std::vector<VascularSystem> vertex_systems() const;

    // 1 for the vertices downstream of `from` (the rest of its own segment and everything that
    // branches off later), otherwise 0.
    std::vector<std::uint8_t> downstream_of(const TreePoint& from) const;
    // 1 for the vertices of this segment of the tree, otherwise 0.
    std::vector<std::uint8_t> vertices_of(int segment) const;
    // Number of terminal branches downstream, in the segment's tree, and in its whole system, which
    // may have several trees.
    int ends_downstream_of(int segment) const;
    int ends_in_tree_of(int segment) const;
    int ends_in_system_of(int segment) const;

    VascularSystem system_of(int segment) const;

    // For the user: where on its branch a point is, what lies downstream of it, and its share of
    // the flow through the root of its tree (`flow_shares` per segment; may be empty). Empty for
    // segment -1.
    std::string describe(const TreePoint& point, std::span<const double> flow_shares) const;

  private:
    std::vector<TreePoint> points_;       // per vertex
    std::vector<int> parent_;             // per segment
    std::vector<VascularSystem> system_;  // per segment
    std::vector<double> length_mm_;       // per segment
    std::vector<int> ends_;               // per segment: terminal branches downstream of it
    std::vector<int> root_;               // per segment: the root of its tree
};

}  // namespace hepatica
