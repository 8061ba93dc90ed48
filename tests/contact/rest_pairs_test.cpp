// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/rest_pairs.h"

#include <gtest/gtest.h>

#include "core/contact/patch_tree.h"
#include "core/mesh/brick_mesh.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {
namespace {

// Two bars side by side, `apart_mm` between them.
TetMesh two_bars(double apart_mm) {
    TetMesh both = kuhn_brick(Vec3(40, 4, 4), {10, 1, 1});
    const TetMesh other = both;
    const auto first = static_cast<int>(both.vertices_mm.size());
    for (const Vec3& v : other.vertices_mm)
        both.vertices_mm.push_back(v + Vec3(0, 4 + apart_mm, 0));
    for (auto t : other.tetrahedra) {
        for (int& v : t) v += first;
        both.tetrahedra.push_back(t);
    }
    return both;
}

// Of the pairs left out: those within one bar, and those between both.
std::array<int, 2> left_out(double apart_mm, double gap_mm) {
    const TetMesh bars = two_bars(apart_mm);
    const SurfacePatches patches(boundary_triangles(bars), 8);
    std::vector<Box> boxes;
    for (std::size_t p = 0; p < patches.size(); ++p) {
        boxes.push_back(patches.box(p, bars.vertices_mm));
        boxes.back().grow(0.5 * gap_mm);
    }
    const auto candidates = PatchTree(boxes).meeting_pairs();
    const RestPairs pairs(patches, bars.vertices_mm, candidates, gap_mm);
    const auto bar_of = [&](int patch) {
        return patches.vertices_of(patch)[0] >= static_cast<int>(bars.vertices_mm.size() / 2);
    };
    std::array<int, 2> count{0, 0};
    for (int a = 0; a < static_cast<int>(patches.size()); ++a) {
        EXPECT_TRUE(pairs.left_out(a, a));
        for (int b = a + 1; b < static_cast<int>(patches.size()); ++b) {
            EXPECT_EQ(pairs.left_out(a, b), pairs.left_out(b, a));
            count[bar_of(a) == bar_of(b) ? 0 : 1] += pairs.left_out(a, b) ? 1 : 0;
            // Neighbours share a vertex.
            bool share = false;
            for (const int v : patches.vertices_of(a))
                share = share || std::ranges::binary_search(patches.vertices_of(b), v);
            EXPECT_TRUE(!share || pairs.left_out(a, b));
        }
    }
    return count;
}

TEST(RestPairs, NeighboursAreLeftOutAndWhatIsNearAtRest) {
    const auto apart = left_out(1.0, 0.5), near = left_out(0.4, 0.5),
               overlapping = left_out(-1, 0.5);
    EXPECT_EQ(apart[1], 0);
    EXPECT_GT(near[1], 5);
    EXPECT_GT(overlapping[1], 5);
    EXPECT_GT(apart[0], 5);
    EXPECT_EQ(apart[0], near[0]);
    // At the gap itself a pair is left out, just beyond it is not.
    EXPECT_GT(left_out(0.5, 0.5)[1], 0);
    EXPECT_EQ(left_out(0.5 + 1e-9, 0.5)[1], 0);
}

}  // namespace
}  // namespace hepatica
