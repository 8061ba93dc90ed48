// SPDX-License-Identifier: GPL-3.0-or-later
// The vessel's surface as a picture needs it: only the vertices that triangles use, with smooth
// normals, brought up to date every frame in one pass over vertices and triangles. No toolkit.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/vector.h"
#include "core/scene/frame.h"
#include "render/clip_plane.h"

namespace hepatica {

// Not thread-safe. Positions are x, y, z per surface vertex, in mm.
class SurfaceGeometry {
  public:
    enum class Change { none, positions, topology };

    // Takes the frame's positions; rebuilds the list of surface vertices when the frame's topology
    // differs from the last one's. Says what is new. A frame without surface gives none.
    Change update(const Frame& frame);

    const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
    const std::vector<float>& positions_mm() const { return positions_mm_; }
    const std::vector<float>& normals() const { return normals_; }  // unit length, outward
    // Index into the frame's vertices, per surface vertex.
    const std::vector<int>& frame_vertices() const { return frame_vertices_; }

    // Smallest box around all surface vertices; lower > upper where there are none.
    Vec3 lower_mm() const { return lower_mm_; }
    Vec3 upper_mm() const { return upper_mm_; }

  private:
    void rebuild(const Frame& frame);
    void compute_normals();

    std::shared_ptr<const std::vector<std::array<int, 3>>> source_;
    std::uint64_t topology_version_ = 0;
    std::vector<int> frame_vertices_;
    std::vector<std::array<int, 3>> triangles_;  // over the surface vertices
    std::vector<float> positions_mm_;
    std::vector<float> normals_;
    Vec3 lower_mm_ = Vec3::Constant(1);
    Vec3 upper_mm_ = Vec3::Constant(-1);
};

// Where a ray first meets the surface.
struct SurfacePick {
    int triangle = -1;
    std::array<int, 3> vertices{-1, -1, -1};  // of the frame
    std::array<double, 3> weights{0, 0, 0};   // barycentric, sum 1
    int nearest_vertex = -1;                  // of the frame: the one of largest weight
    Vec3 position_mm = Vec3::Zero();
    double distance = 0.0;  // along the direction, in its lengths
};

// Tests every triangle (about a millisecond for 100,000); triangle -1 where nothing is hit in
// front of the origin. Both sides of a triangle count. With a plane only what it leaves is met.
SurfacePick pick_surface(const SurfaceGeometry& surface, const Vec3& origin_mm,
                         const Vec3& direction,
                         const std::optional<ClipPlane>& clip = std::nullopt);

}  // namespace hepatica
