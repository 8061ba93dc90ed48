// SPDX-License-Identifier: GPL-3.0-or-later
// What a checkpoint may give back: numbers of the surface, in ascending order, and no others; and
// gaps at their limits.
#include <gtest/gtest.h>

#include "core/contact/overlaps.h"
#include "tests/contact/bodies.h"

namespace hepatica {
namespace {

TEST(OverlapsLimits, OnlyPatchesAndPiecesOfTheSurfaceAreTaken) {
    test::Boxes boxes;
    boxes.add(Vec3(0, 0, 0), 0.0);
    boxes.add(Vec3(0, 0, 5), 0.3);
    const SurfaceFeatures features = boxes.features(4);
    const int patches = static_cast<int>(features.surface().size());
    ASSERT_EQ(features.pieces(), 2);
    Overlaps overlaps(features);
    EXPECT_TRUE(overlaps.set({{0, patches - 1}}, {{patches - 1, 0}}));
    EXPECT_TRUE(overlaps.any());
    EXPECT_TRUE(overlaps.left_out(0, patches - 1));
    EXPECT_TRUE(overlaps.left_out(patches - 1, 0));
    EXPECT_TRUE(overlaps.left_out(1, patches - 1));  // it lies in the piece
    EXPECT_FALSE(overlaps.left_out(0, patches - 2));
    for (const Overlaps::Pairs& wrong :
         {Overlaps::Pairs{{0, patches}}, Overlaps::Pairs{{patches, 0}}, Overlaps::Pairs{{-1, 1}},
          Overlaps::Pairs{{0, -1}}, Overlaps::Pairs{{1, 2}, {0, 3}}}) {
        EXPECT_FALSE(overlaps.set(wrong, {}));
        EXPECT_FALSE(overlaps.set({}, wrong));
    }
    EXPECT_FALSE(overlaps.set({}, {{0, 2}}));
    EXPECT_TRUE(overlaps.set({}, {{0, 1}}));
    EXPECT_TRUE(overlaps.set({}, {}));
    EXPECT_FALSE(overlaps.any());
}

// Two boxes of 2 mm height, one above the other.
TEST(OverlapsLimits, WhatIsAsNearAsAskedForTouches) {
    for (const double gap : {0.5, 0.25}) {
        test::Boxes boxes;
        boxes.add(Vec3(0, 0, 0), 0.0);
        boxes.add(Vec3(0, 0, 2.0 + gap), 0.0);
        const SurfaceFeatures features = boxes.features(4);
        Overlaps overlaps(features);
        overlaps.find(boxes.mesh.vertices_mm, gap);
        EXPECT_TRUE(overlaps.any());
        EXPECT_TRUE(overlaps.buried().empty());
        EXPECT_FALSE(overlaps.let_go(boxes.mesh.vertices_mm, gap));
        EXPECT_TRUE(overlaps.let_go(boxes.mesh.vertices_mm, 0.999 * gap));
        EXPECT_FALSE(overlaps.any());
        overlaps.find(boxes.mesh.vertices_mm, 0.999 * gap);
        EXPECT_FALSE(overlaps.any());
    }
}

TEST(OverlapsLimits, WhatSlipsIntoAnotherPieceIsLeftOutUntilItIsOut) {
    test::Boxes boxes;
    boxes.add(Vec3::Zero(), 0.0);
    const std::size_t small = boxes.mesh.vertices_mm.size();
    boxes.add(Vec3(0, 0, 4.005), 0.3, 3.0);
    const SurfaceFeatures features = boxes.features(4);
    const auto moved = [&](double by_mm) {
        std::vector<Vec3> x = boxes.mesh.vertices_mm;
        for (std::size_t v = 0; v < small; ++v) x[v].z() += by_mm;
        return x;
    };
    Overlaps overlaps(features);
    overlaps.find(boxes.mesh.vertices_mm, 0.01);
    ASSERT_FALSE(overlaps.touching().empty());
    ASSERT_TRUE(overlaps.buried().empty());
    EXPECT_TRUE(overlaps.let_go(moved(4.0), 0.1));
    EXPECT_FALSE(overlaps.buried().empty());
    EXPECT_TRUE(overlaps.let_go(moved(-4.0), 0.1));
    EXPECT_FALSE(overlaps.any());
}

}  // namespace
}  // namespace hepatica
