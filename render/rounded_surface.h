// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a coarse surface rounder: every triangle becomes four, and the new vertices in the middle
// of the edges move onto the curved surface that the normals describe (Phong tessellation,
// Boubekeur and Alexa 2008). Only the picture changes, not the body. Depends on no toolkit.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/surface_geometry.h"

namespace hepatica {

// The surface's own vertices come first, then one per edge. Not thread-safe.
class RoundedSurface {
  public:
    // `creases` as SurfaceGeometry has them; the surface has no gap there.
    void set_topology(const std::vector<std::array<int, 3>>& triangles, std::size_t vertex_count,
                      const std::vector<std::array<int, 2>>& creases = {});
    // Takes the positions and normals of the surface, which must have the vertex count given to
    // set_topology().
    void update(const SurfaceGeometry& surface);

    std::size_t vertex_count() const { return corner_count_ + edges_.size(); }
    const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
    const std::vector<float>& positions_mm() const { return positions_mm_; }
    const std::vector<float>& normals() const { return normals_; }
    // The two surface vertices of the edge of each new vertex.
    const std::vector<std::array<int, 2>>& edges() const { return edges_; }

  private:
    void find_seams(const std::vector<std::array<int, 2>>& creases);

    std::size_t corner_count_ = 0;
    std::vector<std::array<int, 2>> edges_;  // ascending
    // Edges along creases: that of the outer triangles, and that of the bare ones.
    std::vector<std::array<std::size_t, 2>> seams_;
    std::vector<std::array<int, 3>> triangles_;
    std::vector<float> positions_mm_;
    std::vector<float> normals_;
};

}  // namespace hepatica
