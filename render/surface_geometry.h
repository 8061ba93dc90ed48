// SPDX-License-Identifier: GPL-3.0-or-later
// The vessel's surface as needed for drawing: only the vertices that triangles use, with normals
// that are smooth except for creases where a tear has laid the inside bare, updated every frame in
// one pass over vertices and triangles. Depends on no toolkit.
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

    // Takes the frame's positions, and rebuilds the list of surface vertices when the frame's
    // topology differs from the last one's. Returns what changed. A frame without a surface makes
    // it empty.
    Change update(const Frame& frame);

    const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
    const std::vector<float>& positions_mm() const { return positions_mm_; }
    const std::vector<float>& normals() const { return normals_; }  // unit length, outward
    // For each surface vertex, its index among the frame's vertices.
    const std::vector<int>& frame_vertices() const { return frame_vertices_; }
    // Whether a surface vertex belongs to triangles that a tear has laid bare.
    bool bare(std::size_t surface_vertex) const { return surface_vertex >= outer_count_; }
    // At a crease a vertex of the frame has two surface vertices: one of the triangles that were
    // outside before, and, behind all of those, one of the bare triangles. Ascending by the latter.
    const std::vector<std::array<int, 2>>& creases() const { return creases_; }

    // Bounding box of all surface vertices; lower > upper where there are none.
    Vec3 lower_mm() const { return lower_mm_; }
    Vec3 upper_mm() const { return upper_mm_; }

  private:
    void rebuild(const Frame& frame);
    template <class Chosen>
    void add_triangles(std::vector<int>& surface_vertex, const Chosen& chosen);
    void compute_normals();

    std::shared_ptr<const std::vector<std::array<int, 3>>> source_;
    std::uint64_t topology_version_ = 0;
    std::vector<int> frame_vertices_;  // outer ones first, then those of bare triangles
    std::size_t outer_count_ = 0;
    std::vector<std::array<int, 2>> creases_;
    std::vector<std::array<int, 3>> triangles_;  // indices of surface vertices
    std::vector<float> positions_mm_;
    std::vector<float> normals_;
    Vec3 lower_mm_ = Vec3::Constant(1);
    Vec3 upper_mm_ = Vec3::Constant(-1);
};

// The first intersection of a ray with the surface.
struct SurfacePick {
    int triangle = -1;
    std::array<int, 3> vertices{-1, -1, -1};  // of the frame
    std::array<double, 3> weights{0, 0, 0};   // barycentric, sum 1
    int nearest_vertex = -1;                  // of the frame: the one with the largest weight
    Vec3 position_mm = Vec3::Zero();
    double distance = 0.0;  // in units of the direction's length
};

// Tests every triangle (about a millisecond for 100,000) from both sides (Moeller and Trumbore
// 1997). `triangle` is -1 where nothing is hit in front of the origin. With a clip plane, only the
// part that it leaves can be hit.
SurfacePick pick_surface(const SurfaceGeometry& surface, const Vec3& origin_mm,
                         const Vec3& direction,
                         const std::optional<ClipPlane>& clip = std::nullopt);

}  // namespace hepatica
