// SPDX-License-Identifier: GPL-3.0-or-later
// Times of contact against closed forms, against sampled motions, and against the roots of the
// polynomial that is zero where four points lie in a plane.
#include "core/contact/time_of_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/contact/random_features.h"

namespace hepatica {
namespace {

using test::RandomFeatures;

Vec3 between(const Vec3& a, const Vec3& b, double t) {
    return a + t * (b - a);
}
template <std::size_t N>
std::array<Vec3, N> between(const std::array<Vec3, N>& a, const std::array<Vec3, N>& b, double t) {
    std::array<Vec3, N> now;
    for (std::size_t i = 0; i < N; ++i) now[i] = between(a[i], b[i], t);
    return now;
}

// What was found keeps the features apart up to it. Returns whether that is no longer than it must
// be.
template <class First, class Second>
bool is_first_contact(const Motion<First>& first, const Motion<Second>& second, double gap) {
    const auto found = time_of_contact(first, second, gap, 0.01 * gap);
    const auto apart = [&](double t) {
        return std::sqrt(
            closest(between(first.begin, first.end, t), between(second.begin, second.end, t))
                .squared_mm2);
    };
    if (apart(0.0) <= gap) {
        EXPECT_EQ(found, 0.0);
        return true;
    }
    const double until = found.value_or(1.0);
    constexpr int samples = 200;
    for (int i = 0; i <= samples; ++i)
        EXPECT_GE(apart(until * i / samples), gap * (1 - 1e-9)) << "at " << until * i / samples;
    return !found || apart(*found) <= 1.0101 * gap;
}

TEST(TimeOfContact, KeepsApartAndNoLongerThanItMust) {
    RandomFeatures random(5);
    int early = 0;
    for (int i = 0; i < 2000; ++i) {
        const double gap = std::pow(10.0, random.in(-6, -1));
        early += !is_first_contact(Motion<Vec3>{random.point(), random.point(2)},
                                   Motion<Triangle>{random.triangle(), random.triangle(2)}, gap);
        early += !is_first_contact(Motion<Segment>{random.segment(), random.segment(2)},
                                   Motion<Segment>{random.segment(), random.segment(2)}, gap);
        early += !is_first_contact(Motion<Segment>{random.segment(), random.segment(2)},
                                   Motion<Triangle>{random.triangle(), random.triangle(2)}, gap);
    }
    EXPECT_LT(early, 20);  // of 6000: those that a hundred steps did not lead there
}

// Roots in [0, 1] of a polynomial of third degree given by its values at 0, 1/3, 2/3 and 1.
std::vector<double> roots(const std::array<double, 4>& f) {
    const auto value = [&](double t) {
        const double x = 3 * t;
        return f[0] * (x - 1) * (x - 2) * (x - 3) / -6 + f[1] * x * (x - 2) * (x - 3) / 2 +
               f[2] * x * (x - 1) * (x - 3) / -2 + f[3] * x * (x - 1) * (x - 2) / 6;
    };
    std::vector<double> found;
    constexpr int cells = 4000;
    for (int i = 0; i < cells; ++i) {
        double low = static_cast<double>(i) / cells, high = static_cast<double>(i + 1) / cells;
        if (value(low) * value(high) > 0.0) continue;
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = 0.5 * (low + high);
            (value(low) * value(middle) <= 0.0 ? high : low) = middle;
        }
        found.push_back(0.5 * (low + high));
    }
    return found;
}

// The volume that four moving points span is of third degree in time.
template <class PointsAt>
std::vector<double> times_in_a_plane(const PointsAt& points_at) {
    std::array<double, 4> volume{};
    for (int i = 0; i < 4; ++i) {
        const std::array<Vec3, 4> p = points_at(i / 3.0);
        volume[i] = (p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]);
    }
    return roots(volume);
}

TEST(TimeOfContact, APointMeetsATriangleWhereTheyLieInAPlane) {
    RandomFeatures random(6);
    constexpr double gap = 1e-7;
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        const Motion<Vec3> point{random.point(), random.point(2)};
        const Motion<Triangle> triangle{{random.point(), random.point(), random.point()},
                                        {random.point(2), random.point(2), random.point(2)}};
        const auto now = [&](double t) {
            const Triangle at = between(triangle.begin, triangle.end, t);
            return std::array<Vec3, 4>{at[0], at[1], at[2], between(point.begin, point.end, t)};
        };
        std::optional<double> first;
        for (const double t : times_in_a_plane(now)) {
            const auto p = now(t);
            if (closest(p[3], Triangle{p[0], p[1], p[2]}).squared_mm2 > 1e-18) continue;
            first = t;
            break;
        }
        const auto found = time_of_contact(point, triangle, gap, 0.01 * gap);
        if (!first) continue;
        ++met;
        ASSERT_TRUE(found);
        EXPECT_LE(*found, *first);
        EXPECT_NEAR(*found, *first, 1e-4);
    }
    EXPECT_GT(met, 50);
}

TEST(TimeOfContact, EdgesMeetWhereTheyLieInAPlane) {
    RandomFeatures random(7);
    constexpr double gap = 1e-7;
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        const Motion<Segment> a{{random.point(), random.point()},
                                {random.point(2), random.point(2)}};
        const Motion<Segment> b{{random.point(), random.point()},
                                {random.point(2), random.point(2)}};
        const auto now = [&](double t) {
            const Segment first = between(a.begin, a.end, t), second = between(b.begin, b.end, t);
            return std::array<Vec3, 4>{first[0], first[1], second[0], second[1]};
        };
        std::optional<double> first;
        for (const double t : times_in_a_plane(now)) {
            const auto p = now(t);
            if (closest(Segment{p[0], p[1]}, Segment{p[2], p[3]}).squared_mm2 > 1e-18) continue;
            first = t;
            break;
        }
        const auto found = time_of_contact(a, b, gap, 0.01 * gap);
        if (!first) continue;
        ++met;
        ASSERT_TRUE(found);
        EXPECT_LE(*found, *first);
        EXPECT_NEAR(*found, *first, 1e-4);
    }
    EXPECT_GT(met, 50);
}

TEST(TimeOfContact, AFallInClosedForm) {
    const Triangle floor{Vec3(-10, -10, 0), Vec3(10, -10, 0), Vec3(0, 20, 0)};
    const Motion<Triangle> still{floor, floor};
    const Motion<Vec3> falling{Vec3(1, 2, 5), Vec3(1, 2, -5)};
    EXPECT_NEAR(*time_of_contact(falling, still, 0.1, 1e-3), 0.49, 1e-4);
    // A capsule of radius 1 that comes 10 m in one step, slantwise.
    const Motion<Segment> swept{{Vec3(0, 0, 3), Vec3(1, 0, 4)},
                                {Vec3(0, 0, 3 - 10000), Vec3(1, 0, 4 - 10000)}};
    EXPECT_NEAR(*time_of_contact(swept, still, 1.0, 1e-3), 2e-4, 1e-6);
}

TEST(TimeOfContact, WhatSlidesAlongIsNeverMet) {
    const Triangle floor{Vec3(-10, -10, 0), Vec3(10, -10, 0), Vec3(0, 20, 0)};
    const Motion<Triangle> still{floor, floor};
    const Motion<Vec3> sliding{Vec3(-5, 0, 0.1001), Vec3(5, 0, 0.1001)};
    EXPECT_FALSE(time_of_contact(sliding, still, 0.1, 1e-3));
    // Nor what flies along with it, at any speed.
    const auto moved = [](Triangle t) {
        for (Vec3& corner : t) corner += Vec3(1e4, -1e4, -1e4);
        return t;
    };
    const Vec3 beside(0, 0, 0.2);
    EXPECT_FALSE(time_of_contact(Motion<Vec3>{beside, beside + Vec3(1e4, -1e4, -1e4)},
                                 Motion<Triangle>{floor, moved(floor)}, 0.1, 1e-3));
}

}  // namespace
}  // namespace hepatica
