// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/closest_points.h"

#include <algorithm>
#include <optional>

namespace hepatica {
namespace {

// Where the line through the segment meets the triangle, if both contain that point.
std::optional<SegmentTriangle> crossing(const Segment& segment, const Triangle& triangle) {
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    const double begin = normal.dot(segment[0] - triangle[0]);
    const double end = normal.dot(segment[1] - triangle[0]);
    if (begin * end > 0.0 || begin == end) return std::nullopt;
    const double along = begin / (begin - end);
    const PointTriangle on = closest(point_at(segment, along), triangle);
    // Inside the triangle's borders the point lies in it but for rounding.
    if (std::ranges::any_of(on.weights, [](double w) { return w <= 0.0; })) return std::nullopt;
    return SegmentTriangle{along, on.weights, 0.0};
}

template <class Candidate>
void keep_nearer(Candidate& best, const Candidate& other) {
    if (other.squared_mm2 < best.squared_mm2) best = other;
}

}  // namespace

PointSegment closest(const Vec3& point, const Segment& segment) {
    const Vec3 edge = segment[1] - segment[0];
    const double length = edge.squaredNorm();
    const double along =
        length > 0.0 ? std::clamp(edge.dot(point - segment[0]) / length, 0.0, 1.0) : 0.0;
    return {along, (point - point_at(segment, along)).squaredNorm()};
}

PointTriangle closest(const Vec3& point, const Triangle& triangle) {
    PointTriangle best{{1, 0, 0}, (point - triangle[0]).squaredNorm()};
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3;
        const PointSegment on = closest(point, Segment{triangle[a], triangle[b]});
        PointTriangle candidate{{}, on.squared_mm2};
        candidate.weights[a] = 1.0 - on.along;
        candidate.weights[b] = on.along;
        keep_nearer(best, candidate);
    }
    const Vec3 ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0];
    const Vec3 normal = ab.cross(ac), ap = point - triangle[0];
    const double area = normal.squaredNorm();
    if (!(area > 0.0)) return best;
    const double v = normal.dot(ap.cross(ac)) / area, w = normal.dot(ab.cross(ap)) / area;
    if (v < 0.0 || w < 0.0 || v + w > 1.0) return best;
    PointTriangle inside{{1.0 - v - w, v, w}, 0.0};
    inside.squared_mm2 = (point - point_at(triangle, inside.weights)).squaredNorm();
    keep_nearer(best, inside);
    return best;
}

SegmentSegment closest(const Segment& first, const Segment& second) {
    SegmentSegment best{0, 0, (first[0] - second[0]).squaredNorm()};
    for (int end = 0; end < 2; ++end) {
        const PointSegment on_second = closest(first[end], second);
        keep_nearer(best, {static_cast<double>(end), on_second.along, on_second.squared_mm2});
        const PointSegment on_first = closest(second[end], first);
        keep_nearer(best, {on_first.along, static_cast<double>(end), on_first.squared_mm2});
    }
    const Vec3 d = first[1] - first[0], e = second[1] - second[0], r = first[0] - second[0];
    const double dd = d.squaredNorm(), ee = e.squaredNorm(), de = d.dot(e);
    const double determinant = dd * ee - de * de;
    if (!(determinant > 0.0)) return best;
    const double s = (de * e.dot(r) - ee * d.dot(r)) / determinant;
    const double t = (dd * e.dot(r) - de * d.dot(r)) / determinant;
    if (s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0) return best;
    keep_nearer(best, {s, t, (point_at(first, s) - point_at(second, t)).squaredNorm()});
    return best;
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

// The closest points of two triangles lie on an edge of one of them.
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
