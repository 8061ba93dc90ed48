// SPDX-License-Identifier: GPL-3.0-or-later
// Largest principal stretch of a deforming surface, sqrt(lambda_max(F'F)) of its triangles with
// the in-plane deformation gradient F: of the whole surface, and at each of its vertices.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/vector.h"
#include "core/scene/frame.h"

namespace hepatica {

class SurfaceStretch {
  public:
    // Rest positions of the untorn body's vertices.
    explicit SurfaceStretch(std::vector<Vec3> rest_mm) : rest_mm_(std::move(rest_mm)) {}

    const std::vector<Vec3>& rest_mm() const { return rest_mm_; }

    // The frame's vertices, or those that they come from (TearView), are those at rest.
    // O(triangles), and more where the surface is another one than in the frame before.
    void see(const Frame& frame);
    double largest() const { return largest_; }  // in the frame that was seen last; at least 1

    // The largest stretch of the triangles at each vertex, at least 1. Costs what see() does.
    std::vector<float> of_vertices(const Frame& frame);

  private:
    // Of a triangle with rest edges e1, e2: the inverse [a, b; 0, c] of the upper triangular R with
    // R'R = [e1.e1, e1.e2; e1.e2, e2.e2].
    struct Rest {
        double a = 0.0, b = 0.0, c = 0.0;
    };
    void take_surface(const Frame& frame);
    double squared(std::size_t triangle, const Frame& frame) const;

    std::vector<Vec3> rest_mm_;
    std::shared_ptr<const std::vector<std::array<int, 3>>> surface_;
    std::vector<Rest> triangles_;
    double largest_ = 1.0;
};

}  // namespace hepatica
