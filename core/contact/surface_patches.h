// SPDX-License-Identifier: GPL-3.0-or-later
// A surface divided into patches of neighbouring triangles, each with a box that follows the
// vertices: a contact search tests the boxes first.
#pragma once

#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/contact/closest_points.h"

namespace hepatica {

// Axis-aligned; empty where low > high.
struct Box {
    Vec3 low = Vec3::Constant(INFINITY);
    Vec3 high = Vec3::Constant(-INFINITY);

    void add(const Vec3& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    void grow(double margin) {
        low.array() -= margin;
        high.array() += margin;
    }
    // Boxes that touch count as meeting.
    bool meets(const Box& other) const {
        return (low.array() <= other.high.array()).all() &&
               (other.low.array() <= high.array()).all();
    }
};

inline Triangle corners_of(const std::array<int, 3>& triangle, std::span<const Vec3> positions_mm) {
    return {positions_mm[triangle[0]], positions_mm[triangle[1]], positions_mm[triangle[2]]};
}

inline Box box_around(const Triangle& triangle) {
    Box box;
    for (const Vec3& corner : triangle) box.add(corner);
    return box;
}

// Thread safety: const access only.
class SurfacePatches {
  public:
    // Grows each patch across edges from the first triangle that is left, ring by ring, so that it
    // stays compact; deterministic. A patch has at most `triangles_in_patch` >= 1 triangles.
    explicit SurfacePatches(std::vector<std::array<int, 3>> triangles, int triangles_in_patch = 24);

    const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
    std::size_t size() const { return triangles_of_.size(); }
    // Ascending.
    std::span<const int> triangles_of(std::size_t patch) const { return triangles_of_[patch]; }
    // Each once, ascending.
    std::span<const int> vertices_of(std::size_t patch) const { return vertices_of_[patch]; }

    Box box(std::size_t patch, std::span<const Vec3> positions_mm) const;
    // Triangles whose boxes meet this one, ascending. Several boxes are tested in one pass over all
    // patches, whose own boxes are most of the cost.
    std::vector<int> triangles_in(const Box& box, std::span<const Vec3> positions_mm) const;
    std::vector<std::vector<int>> triangles_in(std::span<const Box> boxes,
                                               std::span<const Vec3> positions_mm) const;

  private:
    std::vector<std::array<int, 3>> triangles_;
    std::vector<std::vector<int>> triangles_of_, vertices_of_;
};

}  // namespace hepatica
