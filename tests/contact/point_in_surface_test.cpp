// SPDX-License-Identifier: GPL-3.0-or-later
// Points in and beside boxes, of which the closed form knows on which side they are.
#include "core/contact/point_in_surface.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/contact/bodies.h"

namespace hepatica {
namespace {

TEST(PointInSurface, LiesInABoxWhereItsCoordinatesDo) {
    test::Boxes boxes;
    boxes.add(Vec3(0, 0, 0), 0.0);
    const auto features = boxes.features(4);
    const SurfacePatches& surface = features.surface();
    const auto& x = boxes.mesh.vertices_mm;
    const std::vector<Box> around = boxes_of_patches(surface, x);
    std::vector<int> all(surface.size());
    std::iota(all.begin(), all.end(), 0);
    test::RandomFeatures random(3);
    int inside = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3 point = random.point(4.0);
        const bool in = (point.cwiseAbs() - Vec3(3, 1, 1)).maxCoeff() < 0.0;
        EXPECT_EQ(lies_within(point, surface, all, around, x), in) << point.transpose();
        inside += in ? 1 : 0;
    }
    EXPECT_GT(inside, 50);
    // Along the diagonals of its faces and through its corners.
    EXPECT_TRUE(lies_within(Vec3::Zero(), surface, all, around, x));
    EXPECT_FALSE(lies_within(Vec3(0, 0, 3), surface, all, around, x));
}

}  // namespace
}  // namespace hepatica
