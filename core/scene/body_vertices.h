// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of the vertices of a patient's body at rest: where they lie, to which place on the
// vessel tree they belong, which are fixed and which on the surface. It follows the body where that
// tears: a vertex that is split off has what its parent has.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/mesh/tet_mesh.h"
#include "core/scene/scene_spec.h"
#include "core/scene/vertex_places.h"
#include "core/tear/torn_topology.h"

namespace hepatica {

// Positions in mm; all lists have one entry per vertex unless stated otherwise. `whole` is always
// the body as it was built, and `torn` its present topology, null where it does not tear. Not
// thread-safe.
class BodyVertices {
  public:
    // Fixes the vertices around these ends of the tree. Throws InputError if the tree is empty.
    BodyVertices(const TetMesh& whole, const VesselTree& tree, FixedEnds ends);

    // Follows the body to another version of its topology; otherwise does nothing.
    void follow(const TetMesh& whole, const TornTopology* torn);

    // Split vertices have the rest position of their parents.
    const std::vector<Vec3>& rest_mm() const { return rest_mm_; }
    const std::vector<VertexPlace>& places() const { return places_; }
    const std::vector<std::uint8_t>& fixed() const { return fixed_; }  // 0 or 1
    // A third of the area of the surface's triangles around each vertex, at rest. Computed when it
    // is first asked for after a tear.
    const std::vector<double>& areas_mm2(const TetMesh& whole, const TornTopology* torn) const;

    // The vertex of the surface nearest to the point, where the vertices are at these positions.
    // The first of several; the body must not be empty.
    int nearest(const Vec3& point_mm, std::span<const Vec3> positions_mm) const;
    // The mean of the positions of the place's vessel within a radius along it.
    Vec3 axis_near(const VertexPlace& place, std::span<const Vec3> positions_mm) const;

  private:
    std::vector<Vec3> rest_mm_;
    std::vector<VertexPlace> places_;
    std::vector<std::uint8_t> fixed_;
    std::vector<int> on_surface_;            // numbers of vertices
    mutable std::vector<double> areas_mm2_;  // empty until they are needed
    std::uint64_t followed_ = 1;             // version of the topology
};

// The triangles of the body's surface as it is now.
std::vector<std::array<int, 3>> present_surface(const TetMesh& whole, const TornTopology* torn);

}  // namespace hepatica
