// SPDX-License-Identifier: GPL-3.0-or-later
// Closest points of points, segments and triangles, in double. Squared distance is a convex
// quadratic function of the weights, so that its minimum lies where the gradient vanishes or on the
// border, which is a problem of one dimension less: every function compares the few candidates that
// remain, and none divides by a number that may be zero. (Ericson, Real-Time Collision Detection,
// 2005, ch. 5, has the same cases by regions.) Flat triangles and segments of zero length are
// allowed. All lengths in mm. Pure functions.
#pragma once

#include <array>
#include <span>

#include "core/base/vector.h"

namespace hepatica {

using Segment = std::array<Vec3, 2>;
using Triangle = std::array<Vec3, 3>;

// Weights are barycentric: not negative, with sum 1.
struct PointSegment {
    double along = 0.0;  // 0 at the segment's start, 1 at its end
    double squared_mm2 = 0.0;
};
struct PointTriangle {
    std::array<double, 3> weights{};
    double squared_mm2 = 0.0;
};
struct SegmentSegment {
    double along_first = 0.0;
    double along_second = 0.0;
    double squared_mm2 = 0.0;
};
struct SegmentTriangle {
    double along = 0.0;
    std::array<double, 3> weights{};
    double squared_mm2 = 0.0;
};

PointSegment closest(const Vec3& point, const Segment& segment);
PointTriangle closest(const Vec3& point, const Triangle& triangle);
SegmentSegment closest(const Segment& first, const Segment& second);
// Distance 0 where they cross.
SegmentTriangle closest(const Segment& segment, const Triangle& triangle);
// Squared distance; 0 where they cross.
double squared_distance_mm2(const Triangle& first, const Triangle& second);

inline Vec3 point_at(const Segment& segment, double along) {
    return segment[0] + along * (segment[1] - segment[0]);
}
inline Vec3 point_at(const Triangle& triangle, const std::array<double, 3>& weights) {
    return triangle[0] + weights[1] * (triangle[1] - triangle[0]) +
           weights[2] * (triangle[2] - triangle[0]);
}

}  // namespace hepatica
