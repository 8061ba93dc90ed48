// SPDX-License-Identifier: GPL-3.0-or-later
// The lumen of a vessel tree as an implicit body: each stretch of centreline is a round cone (the
// hull of two balls), stretches of one vessel are united, and vessels that meet in a node are
// blended (polynomial smooth minimum) so that the crotch of a bifurcation is rounded. Vessels that
// merely pass close to each other are not blended.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct TubeFieldOptions {
    double radius_factor = 1.0;      // every radius is multiplied by it, > 0
    double minimum_radius_mm = 0.0;  // before the factor
    double blend_in_radii = 0.3;     // width of the blend at a node, in its smallest radius
};

// Immutable after construction: const access from any number of threads.
class TubeField {
  public:
    // Takes the segments named in `segments` (ids in the tree).
    TubeField(const VesselTree& tree, const std::vector<int>& segments,
              const TubeFieldOptions& options);

    // Signed distance to the body's surface [mm], negative inside: exact near a single vessel, a
    // smooth approximation in a blend, infinity further than a radius or so outside.
    double distance_mm(const Vec3& point_mm) const;

    // Radius of the vessel nearest to the point; the smallest of the tree where none is near.
    double radius_mm(const Vec3& point_mm) const;

    // Grows along each vessel from root to ends, vessel after vessel; 0 where none is near. An
    // order for vertices, not a length.
    double position_along(const Vec3& point_mm) const;

    // Bounding box of the body.
    const Vec3& lower_mm() const { return lower_mm_; }
    const Vec3& upper_mm() const { return upper_mm_; }
    double smallest_radius_mm() const { return smallest_radius_mm_; }

    // Points on the surface around every stretch of centreline and at every end, so that a mesher
    // that starts from them misses no vessel.
    std::vector<Vec3> surface_points_mm() const;

  private:
    struct Cone {
        Vec3 a, b;
        double radius_a, radius_b;
        int vessel;  // index into vessels_; cones stand in the order of their vessels
    };
    struct Vessel {
        int proximal_node, distal_node;
    };
    void add_vessel(const VesselTree& tree, int segment, const TubeFieldOptions& options);
    void build_grid();
    // Calls visit(cell, index of a cone) for every cell that the cone reaches into.
    template <class Visit>
    void for_each_cell(const Cone& cone, const Visit& visit) const;
    // Nearest cone (-1 where none is near) and how far along its axis the point lies, in [0, 1].
    struct Foot {
        int cone = -1;
        double share = 0.0;
    };
    Foot foot_of(const Vec3& point_mm) const;
    // Cones near a point; empty where there are none.
    std::span<const int> cones_near(const Vec3& point_mm) const;
    void add_surface_point(const Vec3& centre, const Vec3& direction, double radius,
                           std::vector<Vec3>& points) const;
    void add_ring(const Cone& cone, double share, int turn, std::vector<Vec3>& points) const;
    static double distance_to(const Cone& cone, const Vec3& point_mm);
    double blend_width_mm(const Vessel& a, const Vessel& b) const;

    std::vector<Cone> cones_;
    std::vector<Vessel> vessels_;
    std::vector<double> node_blend_mm_;  // by node id; 0 where no blend
    Vec3 lower_mm_ = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 upper_mm_ = Vec3::Constant(-std::numeric_limits<double>::infinity());
    double smallest_radius_mm_ = std::numeric_limits<double>::infinity();

    // Which cones reach into each cell of a regular grid.
    double reach_mm_ = 0.0;  // how far outside a cone it is still looked at
    double cell_mm_ = 1.0;
    Index3 grid_dims_{0, 0, 0};
    std::vector<int> cell_begin_;
    std::vector<int> cell_cones_;
};

}  // namespace hepatica
