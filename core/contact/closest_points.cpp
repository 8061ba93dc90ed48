// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/closest_points.h"

#include <algorithm>
#include <optional>

#include "core/base/small_matrix_eigen.h"
#include "core/contact/closest_features.h"

namespace hepatica {
namespace {

using small::from_eigen;

// The point where the segment crosses the triangle, if it does.
std::optional<SegmentTriangle> crossing(const Segment& segment, const Triangle& triangle) {
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    const double begin = normal.dot(segment[0] - triangle[0]);
    const double end = normal.dot(segment[1] - triangle[0]);
    if (begin * end > 0.0 || begin == end) return std::nullopt;
    const double along = begin / (begin - end);
    const PointTriangle on = closest(point_at(segment, along), triangle);
    // Within the triangle's borders, the point is in its plane up to rounding.
    if (std::ranges::any_of(on.weights, [](double w) { return w <= 0.0; })) return std::nullopt;
    return SegmentTriangle{along, on.weights, 0.0};
}

template <class Candidate>
void keep_nearer(Candidate& best, const Candidate& other) {
    if (other.squared_mm2 < best.squared_mm2) best = other;
}

}  // namespace

PointSegment closest(const Vec3& point, const Segment& segment) {
    const auto on = small::closest_on_segment(from_eigen(point), from_eigen(segment[0]),
                                              from_eigen(segment[1]));
    return {on.along, on.squared};
}

PointTriangle closest(const Vec3& point, const Triangle& triangle) {
    const small::Vector3<double> corners[3] = {from_eigen(triangle[0]), from_eigen(triangle[1]),
                                               from_eigen(triangle[2])};
    const auto on = small::closest_on_triangle(from_eigen(point), corners);
    return {{on.weights[0], on.weights[1], on.weights[2]}, on.squared};
}

SegmentSegment closest(const Segment& first, const Segment& second) {
    const small::Vector3<double> one[2] = {from_eigen(first[0]), from_eigen(first[1])};
    const small::Vector3<double> other[2] = {from_eigen(second[0]), from_eigen(second[1])};
    const auto on = small::closest_on_segments(one, other);
    return {on.along_first, on.along_second, on.squared};
}

SegmentTriangle closest(const Segment& segment, const Triangle& triangle) {
    if (const auto crossed = crossing(segment, triangle)) return *crossed;
    const PointTriangle first = closest(segment[0], triangle), last = closest(segment[1], triangle);
    SegmentTriangle best{0.0, first.weights, first.squared_mm2};
    keep_nearer(best, {1.0, last.weights, last.squared_mm2});
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3;
        const SegmentSegment on = closest(segment, Segment{triangle[a], triangle[b]});
        SegmentTriangle candidate{on.along_first, {}, on.squared_mm2};
        candidate.weights[a] = 1.0 - on.along_second;
        candidate.weights[b] = on.along_second;
        keep_nearer(best, candidate);
    }
    return best;
}

// The closest points of two triangles lie on an edge of at least one of them.
double squared_distance_mm2(const Triangle& first, const Triangle& second) {
    double least = (first[0] - second[0]).squaredNorm();
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3;
        least = std::min(least, closest(Segment{first[a], first[b]}, second).squared_mm2);
        least = std::min(least, closest(Segment{second[a], second[b]}, first).squared_mm2);
    }
    return least;
}

}  // namespace hepatica
