// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/surface_stretch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mesh/brick_mesh.h"
#include "core/mesh/surface.h"

namespace hepatica {
namespace {

// One triangle, moved by a matrix.
double stretch_of(const Mat3& gradient) {
    const std::vector<Vec3> rest{{1, 2, 3}, {4, 1, 3}, {2, 6, 3}};  // in a plane z = const
    SurfaceStretch stretch(rest);
    Frame frame;
    frame.surface = std::make_shared<const std::vector<std::array<int, 3>>>(1, std::array{0, 1, 2});
    for (const Vec3& p : rest) {
        const Vec3 moved = gradient * p;
        for (int axis = 0; axis < 3; ++axis)
            frame.positions_mm.push_back(static_cast<float>(moved[axis]));
    }
    stretch.see(frame);
    return stretch.largest();
}

constexpr double float_digits = 2e-6;

TEST(SurfaceStretch, OfAUniformStretchIsThatStretch) {
    EXPECT_NEAR(stretch_of(Mat3::Identity()), 1.0, float_digits);
    EXPECT_NEAR(stretch_of(Vec3(1.7, 1.0, 1.0).asDiagonal()), 1.7, float_digits);
    EXPECT_NEAR(stretch_of(Vec3(1.2, 1.5, 9.0).asDiagonal()), 1.5, float_digits);
    EXPECT_EQ(stretch_of(Vec3(0.5, 0.8, 1.0).asDiagonal()), 1.0) << "shortening is none";
}

// Simple shear by g: lambda = g/2 + sqrt(1 + g^2/4).
TEST(SurfaceStretch, OfASimpleShearIsTheClosedForm) {
    for (const double g : {0.1, 0.5, 2.0}) {
        Mat3 shear = Mat3::Identity();
        shear(0, 1) = g;
        EXPECT_NEAR(stretch_of(shear), 0.5 * g + std::sqrt(1.0 + 0.25 * g * g), float_digits);
    }
}

TEST(SurfaceStretch, DoesNotSeeARotation) {
    const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    EXPECT_NEAR(stretch_of(turn), 1.0, float_digits);
    const Mat3 both = turn * Mat3(Vec3(1.4, 1.1, 1.0).asDiagonal());
    EXPECT_NEAR(stretch_of(both), 1.4, float_digits);
}

// A brick at rest.
Frame frame_of(const TetMesh& mesh) {
    Frame frame;
    frame.surface =
        std::make_shared<const std::vector<std::array<int, 3>>>(boundary_triangles(mesh));
    for (const Vec3& p : mesh.vertices_mm)
        for (int axis = 0; axis < 3; ++axis)
            frame.positions_mm.push_back(static_cast<float>(p[axis]));
    return frame;
}

TEST(SurfaceStretch, OfAWholeBodyIsThatOfItsMostStretchedTriangle) {
    const TetMesh brick = kuhn_brick(Vec3(4, 2, 2), {8, 4, 4});
    SurfaceStretch stretch(brick.vertices_mm);
    Frame frame = frame_of(brick);
    stretch.see(frame);
    EXPECT_NEAR(stretch.largest(), 1.0, float_digits);
    for (std::size_t i = 0; i < frame.positions_mm.size(); i += 3) frame.positions_mm[i] *= 1.25f;
    stretch.see(frame);
    EXPECT_NEAR(stretch.largest(), 1.25, float_digits);
}

// Only the half beyond x = 2 mm is stretched, to 1.5; a torn body has the stretch of its origins.
TEST(SurfaceStretch, OfVerticesIsThatOfTheTrianglesAroundThem) {
    const TetMesh brick = kuhn_brick(Vec3(4, 2, 2), {8, 4, 4});
    SurfaceStretch stretch(brick.vertices_mm);
    Frame frame = frame_of(brick);
    for (std::size_t i = 0; i < frame.positions_mm.size(); i += 3)
        frame.positions_mm[i] += 0.5f * std::max(0.0f, frame.positions_mm[i] - 2.0f);
    const std::vector<float> before = stretch.of_vertices(frame);
    std::vector<char> shown(brick.vertices_mm.size(), 0);
    for (const auto& t : *frame.surface)
        for (const int v : t) shown[v] = 1;
    for (std::size_t v = 0; v < brick.vertices_mm.size(); ++v) {
        // Within the far end nothing is stretched, which lies across.
        const Vec3& x = brick.vertices_mm[v];
        const bool within = std::abs(x.y() - 1.0) < 0.9 && std::abs(x.z() - 1.0) < 0.9;
        const bool stretched = shown[v] != 0 && x.x() > 1.9 && !(x.x() > 3.9 && within);
        EXPECT_NEAR(before[v], stretched ? 1.5 : 1.0, float_digits) << v;
    }
    frame.tear.emplace();
    std::vector<int> origins(brick.vertices_mm.size());
    std::iota(origins.begin(), origins.end(), 0);
    const int last = origins.back();
    origins.push_back(last);  // a vertex was split, and its clone belongs to all of its triangles
    std::vector<std::array<int, 3>> triangles = *frame.surface;
    for (auto& t : triangles) std::ranges::replace(t, last, last + 1);
    frame.surface = std::make_shared<const std::vector<std::array<int, 3>>>(triangles);
    frame.tear->origins = std::make_shared<const std::vector<int>>(origins);
    for (int axis = 0; axis < 3; ++axis)
        frame.positions_mm.push_back(frame.positions_mm[3 * static_cast<std::size_t>(last) +
                                                        static_cast<std::size_t>(axis)]);
    const std::vector<float> after = stretch.of_vertices(frame);
    EXPECT_EQ(after.back(), before[static_cast<std::size_t>(last)]);
    EXPECT_EQ(after[static_cast<std::size_t>(last)], 1.0f) << "no triangle is left there";
}

}  // namespace
}  // namespace hepatica
