// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/rounded_surface.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/render/fake_frame.h"

namespace hepatica {
namespace {

TEST(RoundedSurface, of_a_coarse_sphere_is_closer_to_the_sphere) {
    const TriangleMesh sphere = testing::sphere(Vec3(3, 2, 1), 10.0);
    Frame frame;
    frame.surface = std::make_shared<const std::vector<std::array<int, 3>>>(sphere.triangles);
    for (const Vec3& vertex : sphere.vertices_mm) {
        for (int axis = 0; axis < 3; ++axis) {
            frame.positions_mm.push_back(static_cast<float>(vertex[axis]));
        }
    }
    SurfaceGeometry surface;
    surface.update(frame);
    RoundedSurface rounded;
    rounded.set_topology(surface.triangles(), surface.frame_vertices().size());
    rounded.update(surface);
    ASSERT_EQ(rounded.triangles().size(), 4 * sphere.triangles.size());
    double flat_error = 0.0;
    double round_error = 0.0;
    for (std::size_t e = 0; e < rounded.edges().size(); ++e) {
        const auto& [a, b] = rounded.edges()[e];
        const auto at = [&](std::size_t v) -> Vec3 {
            return Eigen::Vector3f(rounded.positions_mm().data() + 3 * v).cast<double>();
        };
        const Vec3 flat = 0.5 * (at(static_cast<std::size_t>(a)) + at(static_cast<std::size_t>(b)));
        const Vec3 moved = at(surface.frame_vertices().size() + e);
        flat_error += std::abs((flat - Vec3(3, 2, 1)).norm() - 10.0);
        round_error += std::abs((moved - Vec3(3, 2, 1)).norm() - 10.0);
    }
    EXPECT_LT(round_error, 0.05 * flat_error);
}

TEST(RoundedSurface, of_a_closed_surface_is_closed) {
    const Frame frame = [] {
        Frame made;
        const TriangleMesh sphere = testing::sphere(Vec3::Zero(), 1.0);
        made.surface = std::make_shared<const std::vector<std::array<int, 3>>>(sphere.triangles);
        made.positions_mm.assign(3 * sphere.vertices_mm.size(), 0.0f);
        return made;
    }();
    RoundedSurface rounded;
    rounded.set_topology(*frame.surface, frame.positions_mm.size() / 3);
    std::map<std::pair<int, int>, int> directed;
    for (const auto& [a, b, c] : rounded.triangles()) {
        ++directed[{a, b}];
        ++directed[{b, c}];
        ++directed[{c, a}];
    }
    for (const auto& [edge, count] : directed) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(directed.count({edge.second, edge.first}), 1u);
    }
}

}  // namespace
}  // namespace hepatica
