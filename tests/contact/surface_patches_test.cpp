// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/surface_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/mesh/brick_mesh.h"
#include "core/mesh/surface.h"

namespace hepatica {
namespace {

TEST(SurfacePatches, EveryTriangleIsInOneConnectedPatchThatItsBoxHolds) {
    const TetMesh brick = kuhn_brick(Vec3(60, 20, 20), {12, 4, 4});
    const SurfacePatches patches(boundary_triangles(brick), 16);
    std::set<int> seen;
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const auto triangles = patches.triangles_of(p);
        ASSERT_FALSE(triangles.empty());
        EXPECT_LE(triangles.size(), 16u);
        const Box box = patches.box(p, brick.vertices_mm);
        std::set<int> corners, reached{triangles[0]};
        for (const int t : triangles) {
            EXPECT_TRUE(seen.insert(t).second);
            for (const int v : patches.triangles()[t]) {
                corners.insert(v);
                EXPECT_TRUE((brick.vertices_mm[v].array() >= box.low.array()).all());
                EXPECT_TRUE((brick.vertices_mm[v].array() <= box.high.array()).all());
            }
        }
        const auto vertices = patches.vertices_of(p);
        EXPECT_TRUE(std::equal(vertices.begin(), vertices.end(), corners.begin(), corners.end()));
        // Every triangle is reached over shared edges from the first.
        for (std::size_t round = 0; round < triangles.size(); ++round)
            for (const int t : triangles)
                for (const int other : std::set<int>(reached)) {
                    int shared = 0;
                    for (const int v : patches.triangles()[t])
                        for (const int w : patches.triangles()[other]) shared += v == w;
                    if (shared == 2) reached.insert(t);
                }
        EXPECT_EQ(reached.size(), triangles.size());
    }
    EXPECT_EQ(seen.size(), patches.triangles().size());
    EXPECT_LT(patches.size(), patches.triangles().size() / 8);  // most are nearly full
}

// The last vertex of all among them.
TEST(SurfacePatches, ABoxIsNoLargerThanItsVertices) {
    const TetMesh brick = kuhn_brick(Vec3(60, 20, 20), {6, 3, 3});
    const SurfacePatches patches(boundary_triangles(brick), 7);
    std::vector<Vec3> positions = brick.vertices_mm;
    for (std::size_t v = 0; v < positions.size(); ++v)
        positions[v] += Vec3(std::sin(7.0 * double(v)), std::cos(5.0 * double(v)), 0.1 * double(v));
    bool holds_last = false;
    for (std::size_t p = 0; p < patches.size(); ++p) {
        Box expected;
        for (const int v : patches.vertices_of(p)) {
            expected.add(positions[v]);
            holds_last = holds_last || static_cast<std::size_t>(v) + 1 == positions.size();
        }
        const Box box = patches.box(p, positions);
        EXPECT_EQ(box.low, expected.low);
        EXPECT_EQ(box.high, expected.high);
    }
    EXPECT_TRUE(holds_last);
}

TEST(SurfacePatches, TheTrianglesInSeveralBoxesAreThoseInEach) {
    const TetMesh brick = kuhn_brick(Vec3(60, 20, 20), {12, 4, 4});
    const SurfacePatches patches(boundary_triangles(brick), 16);
    std::vector<Box> boxes(5);  // the last stays empty
    for (int b = 0; b < 4; ++b) {
        boxes[b].add(Vec3(13.0 * b, 3.0 * b, 1.0));
        boxes[b].grow(2.0 + 2.5 * b);
    }
    const auto found = patches.triangles_in(boxes, brick.vertices_mm);
    ASSERT_EQ(found.size(), boxes.size());
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        std::vector<int> expected;
        for (std::size_t t = 0; t < patches.triangles().size(); ++t)
            if (box_around(corners_of(patches.triangles()[t], brick.vertices_mm)).meets(boxes[b]))
                expected.push_back(static_cast<int>(t));
        EXPECT_EQ(found[b], expected) << b;
        EXPECT_EQ(patches.triangles_in(boxes[b], brick.vertices_mm), expected) << b;
        EXPECT_EQ(expected.empty(), b == 4) << b;
    }
}

TEST(SurfacePatches, BoxesThatTouchMeet) {
    Box a, b;
    a.add(Vec3(0, 0, 0));
    a.add(Vec3(1, 1, 1));
    b.add(Vec3(1, 0, 0));
    EXPECT_TRUE(a.meets(b));
    b = {};
    b.add(Vec3(1.0000001, 0, 0));
    EXPECT_FALSE(a.meets(b));
    b.grow(1e-6);
    EXPECT_TRUE(b.meets(a));
    EXPECT_FALSE(a.meets(Box{}));
}

}  // namespace
}  // namespace hepatica
