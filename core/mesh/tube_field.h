// SPDX-License-Identifier: GPL-3.0-or-later
// The lumen of a vessel tree as an implicit body: each piece of centreline is a round cone (the
// convex hull of two balls), the pieces of one vessel are united, and vessels that meet in a node
// are blended (polynomial smooth minimum), which rounds the crotch of a bifurcation. Vessels that
// only pass close to each other are not blended.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct TubeFieldOptions {
    double radius_factor = 1.0;      // factor of every radius, > 0
    double minimum_radius_mm = 0.0;  // lower bound of every radius, before the factor
    double blend_in_radii = 0.3;     // width of the blend at a node, in the node's smallest radii
};

// Immutable after construction: const access from any number of threads.
class TubeField {
  public:
    // Takes the segments named in `segments` (ids in the tree), at least one.
    TubeField(const VesselTree& tree, const std::vector<int>& segments,
              const TubeFieldOptions& options);

    // Signed distance to the body's surface in mm, negative inside: exact near a single vessel, a
    // smooth approximation in a blend. Infinity where no cone is near, which is always farther
    // outside than the widest blend.
    double distance_mm(const Vec3& point_mm) const;

    // Radius of the vessel nearest to the point; the smallest of the tree if none is near.
    double radius_mm(const Vec3& point_mm) const;

    // A number that increases along each vessel from its proximal to its distal end, vessel after
    // vessel; 0 if none is near. It orders vertices and is not a length.
    double position_along(const Vec3& point_mm) const;

    // Bounding box of the body, enlarged by the widest blend (at least a quarter of the smallest
    // radius).
    const Vec3& lower_mm() const { return lower_mm_; }
    const Vec3& upper_mm() const { return upper_mm_; }
    double smallest_radius_mm() const { return smallest_radius_mm_; }

    // Points on the surface around every piece of centreline and at every end, from which a mesher
    // can start without missing a vessel.
    std::vector<Vec3> surface_points_mm() const;

  private:
    struct Cone {
        Vec3 a, b;
        double radius_a, radius_b;
        int vessel;  // index into vessels_; cones are in the order of their vessels
    };
    struct Vessel {
        int proximal_node, distal_node;
    };
    void add_vessel(const VesselTree& tree, int segment, const TubeFieldOptions& options);
    void build_grid();
    // Calls visit(cell) for every cell that the cone reaches into.
    template <class Visit>
    void for_each_cell(const Cone& cone, const Visit& visit) const;
    // Nearest cone (-1 if none is near) and the position along its axis, in [0, 1].
    struct Foot {
        int cone = -1;
        double share = 0.0;
    };
    Foot foot_of(const Vec3& point_mm) const;
    // Cones near a point; may be empty.
    std::span<const int> cones_near(const Vec3& point_mm) const;
    void add_surface_point(const Vec3& centre, const Vec3& direction, double radius,
                           std::vector<Vec3>& points) const;
    void add_ring(const Cone& cone, double share, int turn, std::vector<Vec3>& points) const;
    static double distance_to(const Cone& cone, const Vec3& point_mm);
    double blend_width_mm(const Vessel& a, const Vessel& b) const;

    std::vector<Cone> cones_;
    std::vector<Vessel> vessels_;
    std::vector<double> node_blend_mm_;  // by node id; 0 if not blended
    Vec3 lower_mm_ = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 upper_mm_ = Vec3::Constant(-std::numeric_limits<double>::infinity());
    double smallest_radius_mm_ = std::numeric_limits<double>::infinity();

    // The cones that reach into each cell of a regular grid.
    double reach_mm_ = 0.0;  // distance outside a cone up to which it is considered
    double cell_mm_ = 1.0;
    Index3 grid_dims_{0, 0, 0};
    std::vector<int> cell_begin_;
    std::vector<int> cell_cones_;
};

}  // namespace hepatica
