// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/rounded_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/mesh/brick_mesh.h"
#include "core/mesh/surface.h"
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

// The end of a bar that was torn off: its edge is sharp, its face is flat, and nothing gapes
// between the edge's two sides, although their normals differ.
TEST(RoundedSurface, has_a_sharp_edge_without_a_gap_where_the_inside_lies_bare) {
    const TetMesh brick = kuhn_brick(Vec3(4, 2, 2), {4, 2, 2});
    Frame frame;
    const auto triangles = boundary_triangles(brick);
    frame.surface = std::make_shared<const std::vector<std::array<int, 3>>>(triangles);
    std::vector<std::uint8_t> bare;
    const auto at_end = [&](int v) { return brick.vertices_mm[v].x() > 3.9; };
    for (const auto& t : triangles) bare.push_back(std::ranges::all_of(t, at_end) ? 1 : 0);
    // A round bar, so that its side is rounded: y and z are scaled onto circles.
    for (const Vec3& p : brick.vertices_mm) {
        const Vec3 off(0.0, p.y() - 1.0, p.z() - 1.0);
        const double square = std::max(std::abs(off.y()), std::abs(off.z()));
        const Vec3 round = off.isZero(1e-9) ? off : Vec3(off.normalized() * square);
        for (const double x : {p.x(), round.y(), round.z()})
            frame.positions_mm.push_back(static_cast<float>(x));
    }
    frame.tear.emplace();
    frame.tear->bare = std::make_shared<const std::vector<std::uint8_t>>(bare);
    SurfaceGeometry surface;
    surface.update(frame);
    EXPECT_EQ(surface.creases().size(), 8u) << "the vertices of the end's edge";
    for (const auto& [outer, inner] : surface.creases()) {
        EXPECT_EQ(surface.frame_vertices()[outer], surface.frame_vertices()[inner]);
        EXPECT_FALSE(surface.bare(static_cast<std::size_t>(outer)));
        EXPECT_TRUE(surface.bare(static_cast<std::size_t>(inner)));
        EXPECT_NEAR(surface.normals()[3 * static_cast<std::size_t>(outer)], 0.0, 1e-6) << "sharp";
        EXPECT_NEAR(surface.normals()[3 * static_cast<std::size_t>(inner)], 1.0, 1e-6) << "flat";
    }
    RoundedSurface rounded;
    rounded.set_topology(surface.triangles(), surface.frame_vertices().size(), surface.creases());
    rounded.update(surface);
    // Of every directed edge there is one in the other direction, at the same places.
    using Place = std::array<float, 3>;
    std::map<std::pair<Place, Place>, int> directed;
    const auto place = [&](int v) {
        const float* at = rounded.positions_mm().data() + 3 * static_cast<std::size_t>(v);
        return Place{at[0], at[1], at[2]};
    };
    bool beyond = false;  // the flat end
    for (const auto& [a, b, c] : rounded.triangles()) {
        ++directed[{place(a), place(b)}];
        ++directed[{place(b), place(c)}];
        ++directed[{place(c), place(a)}];
        for (const int v : {a, b, c}) beyond = beyond || place(v)[0] > 4.0f + 1e-6f;
    }
    EXPECT_FALSE(beyond);
    for (const auto& [edge, count] : directed) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(directed.count({edge.second, edge.first}), 1u) << edge.first[0];
    }
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
