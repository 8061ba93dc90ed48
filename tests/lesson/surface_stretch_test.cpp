// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/surface_stretch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/lesson/frames.h"

namespace hepatica {
namespace {

using test::rest_frame;
using test::small_patient;

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

TEST(SurfaceStretch, OfAWholeBodyIsThatOfItsMostStretchedTriangle) {
    SurfaceStretch stretch(small_patient()->mesh.vertices_mm);
    Frame frame = rest_frame();
    stretch.see(frame);
    EXPECT_NEAR(stretch.largest(), 1.0, 1e-3);
    for (std::size_t i = 0; i < frame.positions_mm.size(); i += 3) frame.positions_mm[i] *= 1.25f;
    stretch.see(frame);
    EXPECT_NEAR(stretch.largest(), 1.25, 1e-3);
}

}  // namespace
}  // namespace hepatica
