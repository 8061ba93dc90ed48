// SPDX-License-Identifier: GPL-3.0-or-later
// The tree of boxes against looking at every pair.
#include "core/contact/patch_tree.h"

#include <gtest/gtest.h>

#include "tests/contact/random_features.h"

namespace hepatica {
namespace {

using test::RandomFeatures;

Box random_box(RandomFeatures& random, const Vec3& centre) {
    Box box;
    const Vec3 at = centre + random.point(10);
    box.add(at);
    box.add(at + random.point(4));
    return box;
}

TEST(PatchTree, FindsThePairsThatMeetWhateverMovedBefore) {
    RandomFeatures random(8);
    // Far from the origin single precision is coarse: 3e-5 mm at 500 mm.
    for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(500, -300, 1200)}) {
        std::vector<Box> boxes(200);
        for (Box& box : boxes) box = random_box(random, centre);
        PatchTree tree(boxes);
        for (int move = 0; move < 20; ++move) {
            std::vector<std::array<int, 2>> pairs;
            for (int a = 0; a < 200; ++a)
                for (int b = a + 1; b < 200; ++b)
                    if (boxes[a].meets(boxes[b])) pairs.push_back({a, b});
            EXPECT_EQ(tree.meeting_pairs(), pairs);
            EXPECT_GT(pairs.size(), 20u);
            for (int k = 0; k < 60; ++k) boxes[random.whole(200)] = random_box(random, centre);
            tree.refit(boxes);
        }
    }
}

TEST(PatchTree, BoxesThatTouchInDoubleAreFound) {
    Box a, b;
    a.add(Vec3(100.1, 0, 0));
    a.add(Vec3(101.3, 1, 1));
    b.add(Vec3(101.3, 0, 0));
    b.add(Vec3(102.7, 1, 1));
    const std::vector<Box> boxes{a, b};
    EXPECT_EQ(PatchTree(boxes).meeting_pairs().size(), 1u);
}

}  // namespace
}  // namespace hepatica
