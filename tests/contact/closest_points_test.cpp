// SPDX-License-Identifier: GPL-3.0-or-later
// Two points p of a convex set A and q of B are closest if and only if no corner a of A has
// (p - q).(a - p) < 0 and no corner b of B has (p - q).(b - q) > 0: a proof for every answer, which
// owes nothing to the way it was found.
#include "core/contact/closest_points.h"

#include <gtest/gtest.h>

#include "tests/contact/random_features.h"

namespace hepatica {
namespace {

using test::RandomFeatures;

constexpr int tries = 20000;
constexpr double rounding = 1e-12;  // of the square of the features' size

void expect_closest(const Vec3& p, std::span<const Vec3> a, const Vec3& q, std::span<const Vec3> b,
                    double squared_mm2, double size) {
    const Vec3 apart = p - q;
    const double tolerance = rounding * size * size;
    EXPECT_NEAR(apart.squaredNorm(), squared_mm2, tolerance);
    for (const Vec3& corner : a) EXPECT_GE(apart.dot(corner - p), -tolerance);
    for (const Vec3& corner : b) EXPECT_LE(apart.dot(corner - q), tolerance);
}

void expect_weights(const std::array<double, 3>& weights) {
    for (const double w : weights) EXPECT_GE(w, 0.0);
    EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1.0, 1e-12);
}

TEST(ClosestPoints, PointAndTriangle) {
    RandomFeatures random(1);
    for (int i = 0; i < tries; ++i) {
        const double size = std::pow(10.0, random.in(-3, 3));
        const Triangle triangle = random.triangle(size);
        const Vec3 point = random.whole(10) == 0 ? triangle[random.whole(3)] : random.point(size);
        const PointTriangle on = closest(point, triangle);
        expect_weights(on.weights);
        expect_closest(point, {&point, 1}, point_at(triangle, on.weights), triangle, on.squared_mm2,
                       size);
    }
}

TEST(ClosestPoints, TwoSegments) {
    RandomFeatures random(2);
    for (int i = 0; i < tries; ++i) {
        const double size = std::pow(10.0, random.in(-3, 3));
        const Segment first = random.segment(size);
        Segment second = random.segment(size);
        if (random.whole(5) == 0) second[1] = second[0] + random.in(-2, 2) * (first[1] - first[0]);
        if (random.whole(10) == 0) second[0] = first[random.whole(2)];
        const SegmentSegment on = closest(first, second);
        for (const double along : {on.along_first, on.along_second}) {
            EXPECT_GE(along, 0.0);
            EXPECT_LE(along, 1.0);
        }
        expect_closest(point_at(first, on.along_first), first, point_at(second, on.along_second),
                       second, on.squared_mm2, size);
    }
}

TEST(ClosestPoints, SegmentAndTriangle) {
    RandomFeatures random(3);
    int crossings = 0;
    for (int i = 0; i < tries; ++i) {
        const double size = std::pow(10.0, random.in(-3, 3));
        const Segment segment = random.segment(size);
        const Triangle triangle = random.triangle(size);
        const SegmentTriangle on = closest(segment, triangle);
        expect_weights(on.weights);
        const Vec3 p = point_at(segment, on.along), q = point_at(triangle, on.weights);
        if (on.squared_mm2 == 0.0) {
            ++crossings;
            EXPECT_LE((p - q).norm(), 1e-6 * size);
        } else {
            expect_closest(p, segment, q, triangle, on.squared_mm2, size);
        }
    }
    EXPECT_GT(crossings, tries / 100);
}

TEST(ClosestPoints, ASphereAboveATriangleInClosedForm) {
    const Triangle triangle{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 3, 0)};
    EXPECT_EQ(closest(Vec3(1, 1, 2), triangle).squared_mm2, 4.0);            // its face
    EXPECT_EQ(closest(Vec3(2, -3, 4), triangle).squared_mm2, 25.0);          // an edge
    EXPECT_EQ(closest(Vec3(-3, -4, 12), triangle).squared_mm2, 169.0);       // a corner
    EXPECT_NEAR(closest(Vec3(4, 3, 0), triangle).squared_mm2, 5.76, 1e-12);  // the slope: 12/5
}

// Sampled: never nearer than what was found, and not much farther than it.
TEST(ClosestPoints, TwoTriangles) {
    RandomFeatures random(4);
    constexpr int cells = 12;
    for (int i = 0; i < 300; ++i) {
        const Triangle first = random.triangle(), second = random.triangle();
        const double found = std::sqrt(squared_distance_mm2(first, second));
        EXPECT_NEAR(found, std::sqrt(squared_distance_mm2(second, first)), 1e-9);
        double sampled = INFINITY;
        for (int u = 0; u <= cells; ++u)
            for (int v = 0; u + v <= cells; ++v) {
                const double a = static_cast<double>(u) / cells, b = static_cast<double>(v) / cells;
                const Vec3 point = point_at(first, {1 - a - b, a, b});
                sampled = std::min(sampled, std::sqrt(closest(point, second).squared_mm2));
            }
        EXPECT_LE(found, sampled + 1e-9);
        EXPECT_GE(found, sampled - 4.0 / cells);
    }
    const Triangle flat{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)};
    const Triangle through{Vec3(0.5, 0.5, -1), Vec3(0.5, 0.5, 1), Vec3(3, 3, 0)};
    EXPECT_EQ(squared_distance_mm2(flat, through), 0.0);
    EXPECT_EQ(squared_distance_mm2(through, flat), 0.0);
}

}  // namespace
}  // namespace hepatica
