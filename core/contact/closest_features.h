// SPDX-License-Identifier: GPL-3.0-or-later
// Closest points of points, segments and triangles for host and CUDA device: the functions of
// closest_points.h in plain vectors.
#pragma once

#include "core/base/small_matrix.h"

namespace hepatica::small {

struct OnSegment {
    double along = 0.0;  // 0 at the segment's start, 1 at its end
    double squared = 0.0;
};
struct OnTriangle {
    double weights[3] = {0.0, 0.0, 0.0};
    double squared = 0.0;
};
struct OnSegments {
    double along_first = 0.0, along_second = 0.0;
    double squared = 0.0;
};

HEPATICA_HOST_DEVICE Vector3<double> point_between(const Vector3<double>& begin,
                                                   const Vector3<double>& end, double along) {
    return begin + along * (end - begin);
}
HEPATICA_HOST_DEVICE Vector3<double> point_in(const Vector3<double>* corners,
                                              const double* weights) {
    return corners[0] + weights[1] * (corners[1] - corners[0]) +
           weights[2] * (corners[2] - corners[0]);
}
HEPATICA_HOST_DEVICE double squared_length(const Vector3<double>& a) {
    return dot(a, a);
}

HEPATICA_HOST_DEVICE OnSegment closest_on_segment(const Vector3<double>& point,
                                                  const Vector3<double>& begin,
                                                  const Vector3<double>& end) {
    const Vector3<double> edge = end - begin;
    const double length = squared_length(edge);
    double along = length > 0.0 ? dot(edge, point - begin) / length : 0.0;
    along = along < 0.0 ? 0.0 : (1.0 < along ? 1.0 : along);
    return {along, squared_length(point - point_between(begin, end, along))};
}

HEPATICA_HOST_DEVICE OnTriangle closest_on_triangle(const Vector3<double>& point,
                                                    const Vector3<double>* corners) {
    OnTriangle best{{1.0, 0.0, 0.0}, squared_length(point - corners[0])};
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3;
        const OnSegment on = closest_on_segment(point, corners[a], corners[b]);
        if (!(on.squared < best.squared)) continue;
        best = {{0.0, 0.0, 0.0}, on.squared};
        best.weights[a] = 1.0 - on.along;
        best.weights[b] = on.along;
    }
    const Vector3<double> ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const Vector3<double> normal = cross(ab, ac), ap = point - corners[0];
    const double area = squared_length(normal);
    if (!(area > 0.0)) return best;
    const double v = dot(normal, cross(ap, ac)) / area, w = dot(normal, cross(ab, ap)) / area;
    if (v < 0.0 || w < 0.0 || v + w > 1.0) return best;
    OnTriangle inside{{1.0 - v - w, v, w}, 0.0};
    inside.squared = squared_length(point - point_in(corners, inside.weights));
    return inside.squared < best.squared ? inside : best;
}

HEPATICA_HOST_DEVICE OnSegments closest_on_segments(const Vector3<double>* first,
                                                    const Vector3<double>* second) {
    OnSegments best{0.0, 0.0, squared_length(first[0] - second[0])};
    for (int end = 0; end < 2; ++end) {
        const OnSegment on_second = closest_on_segment(first[end], second[0], second[1]);
        if (on_second.squared < best.squared)
            best = {static_cast<double>(end), on_second.along, on_second.squared};
        const OnSegment on_first = closest_on_segment(second[end], first[0], first[1]);
        if (on_first.squared < best.squared)
            best = {on_first.along, static_cast<double>(end), on_first.squared};
    }
    const Vector3<double> d = first[1] - first[0], e = second[1] - second[0],
                          r = first[0] - second[0];
    const double dd = squared_length(d), ee = squared_length(e), de = dot(d, e);
    const double determinant = dd * ee - de * de;
    if (!(determinant > 0.0)) return best;
    const double s = (de * dot(e, r) - ee * dot(d, r)) / determinant;
    const double t = (dd * dot(e, r) - de * dot(d, r)) / determinant;
    if (s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0) return best;
    const double squared = squared_length(point_between(first[0], first[1], s) -
                                          point_between(second[0], second[1], t));
    return squared < best.squared ? OnSegments{s, t, squared} : best;
}

}  // namespace hepatica::small
