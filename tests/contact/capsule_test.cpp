// SPDX-License-Identifier: GPL-3.0-or-later
// A capsule among random triangles: what is near, and motions that pass through nothing at any
// speed, against looking at every triangle at many moments.
#include "core/contact/capsule.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/brick_mesh.h"
#include "tests/contact/bodies.h"

namespace hepatica {
namespace {

using test::capsule_of;
using test::RandomFeatures;
using test::Soup;
using test::soup_of;

// Of the capsule moved by `by`, to triangle t.
double gap_to(const Capsule& capsule, const Vec3& by, const Soup& soup,
              std::span<const Vec3> positions, int t) {
    const Segment axis = capsule.axis();
    const Segment now{axis[0] + by, axis[1] + by};
    const Triangle corners = corners_of(soup.surface.triangles()[t], positions);
    return std::sqrt(closest(now, corners).squared_mm2) - capsule.radius_mm;
}

TEST(Capsule, FindsWhatIsNear) {
    RandomFeatures random(9);
    int found = 0;
    for (int i = 0; i < 200; ++i) {
        const Soup soup = soup_of(random, 100, 6);
        const Capsule capsule = capsule_of(random);
        const auto near = near_capsule(capsule, soup.surface, soup.vertices, 0.4);
        std::size_t k = 0;
        for (int t = 0; t < 100; ++t) {
            const double gap = gap_to(capsule, Vec3::Zero(), soup, soup.vertices, t);
            if (gap >= 0.4) continue;
            ASSERT_LT(k, near.size());
            EXPECT_EQ(near[k].triangle, t);
            EXPECT_NEAR(near[k].gap_mm, gap, 1e-12);
            const Triangle corners = corners_of(soup.surface.triangles()[t], soup.vertices);
            const Vec3 there = near[k].on_axis_mm + (gap + capsule.radius_mm) * near[k].normal;
            EXPECT_LT((there - point_at(corners, near[k].weights)).norm(), 1e-9);
            ++k;
        }
        EXPECT_EQ(k, near.size());
        found += static_cast<int>(k);
    }
    EXPECT_GT(found, 500);
}

TEST(Capsule, TheSurfaceMovesAsFarAsItIsFree) {
    RandomFeatures random(10);
    constexpr double keep = 0.05;
    int stopped = 0;
    for (int i = 0; i < 200; ++i) {
        const Soup soup = soup_of(random, 40, 8);
        const Capsule capsule = capsule_of(random);
        std::vector<Vec3> to = soup.vertices;
        const Vec3 flight = random.point(20);
        for (Vec3& v : to) v += flight + random.point(1);
        const auto kept = [&](double gap) { return std::min(keep, 0.1 * gap); };
        const double share = free_share(capsule, soup.surface, soup.vertices, to, kept);
        bool begins_within = false;
        for (int t = 0; t < 40; ++t)
            begins_within |= gap_to(capsule, Vec3::Zero(), soup, soup.vertices, t) < 0.0;
        std::vector<Vec3> now = to;
        double least_of_slack = INFINITY;
        for (int sample = 0; sample <= 100; ++sample) {
            for (std::size_t v = 0; v < now.size(); ++v)
                now[v] = soup.vertices[v] + share * sample / 100 * (to[v] - soup.vertices[v]);
            for (int t = 0; t < 40; ++t) {
                const double keep_t = kept(gap_to(capsule, Vec3::Zero(), soup, soup.vertices, t));
                if (keep_t < 0.0) continue;
                const double slack = gap_to(capsule, Vec3::Zero(), soup, now, t) - keep_t;
                EXPECT_GE(slack, -1e-9);
                if (sample == 100) least_of_slack = std::min(least_of_slack, slack);
            }
        }
        if (share == 1.0 || begins_within) continue;
        ++stopped;
        EXPECT_LT(least_of_slack, 0.02);  // it did not stop for nothing
    }
    EXPECT_GT(stopped, 30);
}

// At 0.01 to 100 m/s and 60 Hz: 0.17 to 1700 mm a step.
TEST(Capsule, SlidesThroughNothingAtAnySpeed) {
    RandomFeatures random(11);
    constexpr double keep = 0.05;
    int slid = 0;
    for (int i = 0; i < 300; ++i) {
        const Soup soup = soup_of(random, 60, 8);
        Capsule capsule = capsule_of(random);
        capsule.centre_mm = Vec3(20, 0, 0) + random.point(3);
        const double speed = std::pow(10.0, random.in(-0.8, 3.2));
        Vec3 led = speed * (random.point(6) - capsule.centre_mm).normalized();
        for (int step = 0; step < 8; ++step) {
            const Vec3 gone = slide({&capsule, 1}, {{soup.surface, soup.vertices}}, led, keep);
            // The way is at most five straight stretches; its end is free, and from there on it
            // could go back.
            for (int t = 0; t < 60; ++t)
                EXPECT_GT(gap_to(capsule, gone, soup, soup.vertices, t), 0.99 * keep);
            slid += gone.norm() < 0.99 * led.norm() && gone.norm() > 0.1 * led.norm();
            capsule.centre_mm += gone;
        }
    }
    EXPECT_GT(slid, 20);
}

TEST(Capsule, NeverLeavesAClosedBox) {
    RandomFeatures random(12);
    const TetMesh box = kuhn_brick(Vec3(10, 10, 10), {2, 2, 2});
    const SurfacePatches surface(boundary_triangles(box));
    for (int i = 0; i < 100; ++i) {
        Capsule capsule = capsule_of(random);
        capsule.centre_mm = Vec3(5, 5, 5);
        for (int step = 0; step < 30; ++step) {
            const double speed = std::pow(10.0, random.in(-0.8, 3.2));
            capsule.centre_mm +=
                slide({&capsule, 1}, {{surface, box.vertices_mm}}, random.point(speed), 0.05);
            for (const Vec3& end : capsule.axis())
                EXPECT_TRUE((end.array() > 0.0).all() && (end.array() < 10.0).all());
        }
    }
}

TEST(Capsule, SlidesAlongAFloorInClosedForm) {
    const std::vector<Vec3> floor{Vec3(-100, -100, 0), Vec3(100, -100, 0), Vec3(0, 200, 0)};
    const SurfacePatches surface({{0, 1, 2}});
    const Capsule ball{.centre_mm = Vec3(0, 0, 3), .radius_mm = 1.0};
    const Vec3 gone = slide({&ball, 1}, {{surface, floor}}, Vec3(4, 0, -10), 0.5);
    EXPECT_NEAR(gone.z(), -1.5, 1e-5);
    EXPECT_NEAR(gone.x(), 4.0, 1e-5);
    // What presses already comes no nearer, and is not held back from sliding or leaving.
    const Capsule near{.centre_mm = Vec3(0, 0, 1.1), .radius_mm = 1.0};
    EXPECT_NEAR(slide({&near, 1}, {{surface, floor}}, Vec3(4, 0, -10), 0.5).z(), 0.0, 1e-5);
    EXPECT_NEAR(slide({&near, 1}, {{surface, floor}}, Vec3(4, 0, -10), 0.5).x(), 4.0, 1e-5);
    EXPECT_EQ(slide({&near, 1}, {{surface, floor}}, Vec3(1, 1, 2), 0.5), Vec3(1, 1, 2));
    // Straight on alone it ends where it first is that near.
    const Vec3 straight = approach({&ball, 1}, {{surface, floor}}, Vec3(4, 0, -10), 0.5);
    EXPECT_LT((straight - 0.15 * Vec3(4, 0, -10)).norm(), 1e-5);
    EXPECT_EQ(approach({&ball, 1}, {{surface, floor}}, Vec3(4, 0, 1), 0.5), Vec3(4, 0, 1));
}

}  // namespace
}  // namespace hepatica
