// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/render/fake_frame.h"

namespace hepatica {
namespace {

Frame sphere_frame(const Vec3& centre, double radius_mm) {
    const TriangleMesh mesh = testing::sphere(centre, radius_mm);
    Frame frame;
    // Two vertices that no triangle uses come first, as the inside of a body does.
    frame.positions_mm.assign(6, 1e6f);
    auto triangles = mesh.triangles;
    for (auto& corners : triangles) {
        for (int& corner : corners) corner += 2;
    }
    for (const Vec3& vertex : mesh.vertices_mm) {
        for (int axis = 0; axis < 3; ++axis) {
            frame.positions_mm.push_back(static_cast<float>(vertex[axis]));
        }
    }
    frame.surface = std::make_shared<const std::vector<std::array<int, 3>>>(triangles);
    return frame;
}

TEST(SurfaceGeometry, leaves_out_inner_vertices_and_bounds_the_rest) {
    SurfaceGeometry surface;
    EXPECT_EQ(surface.update(sphere_frame(Vec3(1, 2, 3), 5.0)), SurfaceGeometry::Change::topology);
    EXPECT_NEAR((surface.lower_mm() - Vec3(-4, -3, -2)).norm(), 0.0, 0.05);
    EXPECT_NEAR((surface.upper_mm() - Vec3(6, 7, 8)).norm(), 0.0, 0.05);
    for (const int vertex : surface.frame_vertices()) EXPECT_GE(vertex, 2);
}

TEST(SurfaceGeometry, normals_of_a_sphere_point_outwards) {
    SurfaceGeometry surface;
    const Vec3 centre(1, 2, 3);
    surface.update(sphere_frame(centre, 5.0));
    for (std::size_t v = 0; v < surface.frame_vertices().size(); ++v) {
        const Eigen::Vector3f position(surface.positions_mm().data() + 3 * v);
        const Eigen::Vector3f normal(surface.normals().data() + 3 * v);
        const Vec3 outward = (position.cast<double>() - centre).normalized();
        EXPECT_GT(normal.cast<double>().dot(outward), 0.995);
    }
}

TEST(SurfaceGeometry, rays_meet_a_sphere_where_geometry_says) {
    const Vec3 centre(1, -2, 3);
    const double radius = 4.0;
    SurfaceGeometry surface;
    surface.update(sphere_frame(centre, radius));
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < 300; ++i) {
        const Vec3 origin =
            centre + 20.0 * Vec3(uniform(random), uniform(random), 2.0).normalized();
        const Vec3 aim = centre + 6.0 * Vec3(uniform(random), uniform(random), uniform(random));
        const Vec3 direction = (aim - origin).normalized();
        const double along = (centre - origin).dot(direction);
        const double miss = (centre - origin - along * direction).norm();
        const SurfacePick pick = pick_surface(surface, origin, direction);
        if (miss > radius * 1.001) {
            EXPECT_EQ(pick.triangle, -1);
        } else if (miss < radius * 0.95) {
            ASSERT_GE(pick.triangle, 0);
            EXPECT_NEAR(pick.distance, along - std::sqrt(radius * radius - miss * miss), 0.15);
            EXPECT_NEAR(pick.weights[0] + pick.weights[1] + pick.weights[2], 1.0, 1e-12);
            EXPECT_GE(pick.nearest_vertex, 2);
        }
    }
}

TEST(SurfaceGeometry, a_ray_away_from_the_surface_or_without_one_meets_nothing) {
    SurfaceGeometry surface;
    EXPECT_EQ(pick_surface(surface, Vec3::Zero(), Vec3::UnitX()).triangle, -1);
    surface.update(sphere_frame(Vec3(10, 0, 0), 2.0));
    EXPECT_EQ(pick_surface(surface, Vec3::Zero(), -Vec3::UnitX()).triangle, -1);
    EXPECT_GE(pick_surface(surface, Vec3::Zero(), Vec3::UnitX()).triangle, 0);
}

// A ray through the middle of a sphere of radius 4, which a plane cuts in many ways.
TEST(SurfaceGeometry, a_ray_meets_only_what_a_plane_leaves) {
    SurfaceGeometry surface;
    surface.update(sphere_frame(Vec3(10, 0, 0), 4.0));
    const auto distance = [&](const Vec3& point, const Vec3& inward) {
        return pick_surface(surface, Vec3::Zero(), Vec3::UnitX(), ClipPlane{point, inward});
    };
    constexpr double near = 6.0, far = 14.0, tolerance = 0.15;
    // The plane in front of it, through it, and behind it: what is nearer to the eye is gone.
    EXPECT_NEAR(distance(Vec3(2, 9, 9), Vec3::UnitX()).distance, near, tolerance);
    EXPECT_NEAR(distance(Vec3(10, 9, 9), Vec3::UnitX()).distance, far, tolerance);
    EXPECT_EQ(distance(Vec3(15, 9, 9), Vec3::UnitX()).triangle, -1);
    EXPECT_NEAR(distance(Vec3(-5, 0, 0), Vec3::UnitX()).distance, near, tolerance);
    // Turned about, what is farther is gone.
    EXPECT_EQ(distance(Vec3(2, 0, 0), -Vec3::UnitX()).triangle, -1);
    EXPECT_NEAR(distance(Vec3(10, 0, 0), -Vec3::UnitX()).distance, near, tolerance);
    EXPECT_EQ(distance(Vec3(-5, 0, 0), -Vec3::UnitX()).triangle, -1);
    // Along the ray: all of it or nothing.
    EXPECT_NEAR(distance(Vec3(0, -1, 0), Vec3::UnitY()).distance, near, tolerance);
    EXPECT_EQ(distance(Vec3(0, 1, 0), Vec3::UnitY()).triangle, -1);
    // Across at 45 degrees: it leaves what lies beyond x = 10 on the ray.
    EXPECT_NEAR(distance(Vec3(10, 0, 0), Vec3(1, 1, 0).normalized()).distance, far, tolerance);
}

TEST(SurfaceGeometry, follows_positions_without_rebuilding) {
    SurfaceGeometry surface;
    Frame frame = sphere_frame(Vec3::Zero(), 1.0);
    surface.update(frame);
    for (float& value : frame.positions_mm) value += 3.0f;
    EXPECT_EQ(surface.update(frame), SurfaceGeometry::Change::positions);
    EXPECT_EQ(surface.update(frame), SurfaceGeometry::Change::none);
    EXPECT_NEAR(surface.lower_mm().x(), 2.0, 0.05);
    ++frame.topology_version;
    EXPECT_EQ(surface.update(frame), SurfaceGeometry::Change::topology);
}

}  // namespace
}  // namespace hepatica
