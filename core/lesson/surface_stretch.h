// SPDX-License-Identifier: GPL-3.0-or-later
// How far the surface of a play is stretched and torn: the largest principal stretch of its
// triangles, sqrt of the largest eigenvalue of F'F in the triangle's plane, and the area of the
// faces that came apart.
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
    // Of the whole body, in mm.
    explicit SurfaceStretch(std::vector<Vec3> rest_mm) : rest_mm_(std::move(rest_mm)) {}

    // O(triangles). The frames of one play, in order.
    void see(const Frame& frame);

    double largest() const { return largest_; }  // 1 at rest
    // Half of what the surface has grown by since the first frame, both at rest: each face that
    // came apart has two sides now.
    double torn_area_mm2() const { return 0.5 * (area_mm2_ - whole_mm2_); }

  private:
    // Of a triangle at rest with edges e1, e2: the inverse of the upper triangular R with
    // R'R = [e1.e1, e1.e2; e1.e2, e2.e2].
    struct Rest {
        double a = 0.0, b = 0.0, c = 0.0;
    };
    void take_surface(const Frame& frame);

    std::vector<Vec3> rest_mm_;
    std::shared_ptr<const std::vector<std::array<int, 3>>> surface_;
    std::vector<Rest> triangles_;
    double area_mm2_ = 0.0;
    double whole_mm2_ = -1.0;  // < 0: not yet seen
    double largest_ = 1.0;
};

}  // namespace hepatica
