// SPDX-License-Identifier: GPL-3.0-or-later
// A thinned skeleton is one, keeps the roots, and each of its nodes has the vertices that were
// asked for on its way up to the next one.
#include "gpu/step/thinned_skeleton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hepatica {
namespace {

// A straight line of nodes 1 mm apart, with so many vertices beside each.
struct Line {
    CoarseSkeleton skeleton;
    std::vector<Vec3> vertices;

    Line(int nodes, int vertices_each) {
        for (int n = 0; n < nodes; ++n) {
            skeleton.positions_mm.emplace_back(n, 0.0, 0.0);
            skeleton.radii_mm.push_back(1.0);
            skeleton.parent.push_back(n - 1);
            for (int v = 0; v < vertices_each; ++v) vertices.emplace_back(n, 0.1 * v, 1.0);
        }
    }
};

TEST(ThinnedSkeleton, KeepsANodeForSoManyVertices) {
    const Line line(41, 4);
    const CoarseSkeleton thin = gpu::thinned(line.skeleton, line.vertices, 16);
    validate(thin);
    ASSERT_EQ(thin.size(), 11);
    for (int n = 0; n < thin.size(); ++n) {
        EXPECT_EQ(thin.positions_mm[n], Vec3(4.0 * n, 0.0, 0.0));
        EXPECT_EQ(thin.parent[n], n - 1);
    }
}

TEST(ThinnedSkeleton, LeavesOneWithEnoughAsItIs) {
    const Line line(20, 16);
    const CoarseSkeleton same = gpu::thinned(line.skeleton, line.vertices, 16);
    EXPECT_EQ(same.positions_mm, line.skeleton.positions_mm);
    EXPECT_EQ(same.parent, line.skeleton.parent);
    EXPECT_EQ(same.radii_mm, line.skeleton.radii_mm);
    EXPECT_EQ(gpu::thinned({}, {}, 16).size(), 0);
}

TEST(ThinnedSkeleton, OfRandomForestsIsOneAndKeepsTheirRoots) {
    std::mt19937 random(20261127);
    std::uniform_real_distribution<double> place(0.0, 100.0);
    for (int trial = 0; trial < 50; ++trial) {
        CoarseSkeleton forest;
        int roots = 0;
        for (int n = 0; n < 200; ++n) {
            const bool root = n == 0 || random() % 40 == 0;
            forest.positions_mm.emplace_back(place(random), place(random), place(random));
            forest.radii_mm.push_back(0.5 + 0.01 * place(random));
            forest.parent.push_back(root ? -1
                                         : static_cast<int>(random() % static_cast<unsigned>(n)));
            roots += root ? 1 : 0;
        }
        std::vector<Vec3> vertices;
        for (int v = 0; v < 1000; ++v)
            vertices.emplace_back(place(random), place(random), place(random));
        const CoarseSkeleton thin = gpu::thinned(forest, vertices, 16);
        validate(thin);
        EXPECT_EQ(std::ranges::count(thin.parent, -1), roots);
        EXPECT_LT(thin.size(), forest.size());
    }
}

}  // namespace
}  // namespace hepatica
