// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/time_of_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hepatica {
namespace {

constexpr int most_steps = 100;

// The corners of a point, a segment or a triangle as a range.
std::span<const Vec3> corners(const Vec3& point) {
    return {&point, 1};
}
template <std::size_t N>
std::span<const Vec3> corners(const std::array<Vec3, N>& feature) {
    return feature;
}

Vec3 at(const Motion<Vec3>& motion, double time) {
    return motion.begin + time * (motion.end - motion.begin);
}
template <std::size_t N>
std::array<Vec3, N> at(const Motion<std::array<Vec3, N>>& motion, double time) {
    std::array<Vec3, N> now;
    for (std::size_t i = 0; i < N; ++i)
        now[i] = motion.begin[i] + time * (motion.end[i] - motion.begin[i]);
    return now;
}

// Vector from the second feature to the first.
Vec3 separation(const Vec3& point, const Triangle& triangle) {
    return point - point_at(triangle, closest(point, triangle).weights);
}
Vec3 separation(const Segment& first, const Segment& second) {
    const SegmentSegment on = closest(first, second);
    return point_at(first, on.along_first) - point_at(second, on.along_second);
}
Vec3 separation(const Segment& segment, const Triangle& triangle) {
    const SegmentTriangle on = closest(segment, triangle);
    if (on.squared_mm2 == 0.0) return Vec3::Zero();
    return point_at(segment, on.along) - point_at(triangle, on.weights);
}

// The greatest speed of a corner along n.
template <class Feature>
double fastest_along(const Motion<Feature>& motion, const Vec3& n) {
    double speed = -std::numeric_limits<double>::infinity();
    const auto begin = corners(motion.begin), end = corners(motion.end);
    for (std::size_t i = 0; i < begin.size(); ++i)
        speed = std::max(speed, n.dot(end[i] - begin[i]));
    return speed;
}

template <class First, class Second>
std::optional<double> advance(const Motion<First>& first, const Motion<Second>& second,
                              double gap_mm, double tolerance_mm) {
    double time = 0.0;
    for (int step = 0; step < most_steps; ++step) {
        const Vec3 apart = separation(at(first, time), at(second, time));
        const double distance = apart.norm();
        // A pair that starts within the tolerance may go on if it is not approaching.
        if (!(distance > gap_mm) || (time > 0.0 && distance <= gap_mm + tolerance_mm)) return time;
        const Vec3 n = apart / distance;
        const double closing = fastest_along(first, -n) + fastest_along(second, n);
        if (closing <= 0.0) return std::nullopt;
        const double safe = (distance - gap_mm) / closing;
        if (time + safe >= 1.0) return std::nullopt;
        if (time + safe == time) return time;
        time += safe;
    }
    return time;
}

}  // namespace

std::optional<double> time_of_contact(const Motion<Vec3>& point, const Motion<Triangle>& triangle,
                                      double gap_mm, double tolerance_mm) {
    return advance(point, triangle, gap_mm, tolerance_mm);
}

std::optional<double> time_of_contact(const Motion<Segment>& first, const Motion<Segment>& second,
                                      double gap_mm, double tolerance_mm) {
    return advance(first, second, gap_mm, tolerance_mm);
}

std::optional<double> time_of_contact(const Motion<Segment>& axis, const Motion<Triangle>& triangle,
                                      double gap_mm, double tolerance_mm) {
    return advance(axis, triangle, gap_mm, tolerance_mm);
}

}  // namespace hepatica
