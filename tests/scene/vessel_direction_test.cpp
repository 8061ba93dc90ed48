// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/vessel_direction.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

TEST(VesselDirection, IsThatOfTheStretchAtThePlace) {
    VesselTree tree;
    VesselSegment segment;
    // Along x for 10 mm, then along -z for 5 mm, with a point given twice.
    segment.points_mm = {Vec3(1, 2, 3), Vec3(11, 2, 3), Vec3(11, 2, 3), Vec3(11, 2, -2)};
    tree.segments = {segment};
    for (const double at : {0.0, 3.0, 9.99})
        EXPECT_EQ(vessel_direction(tree, {0, at}), Vec3(1, 0, 0)) << at;
    for (const double at : {10.01, 14.0, 15.0, 99.0})
        EXPECT_EQ(vessel_direction(tree, {0, at}), Vec3(0, 0, -1)) << at;
    EXPECT_EQ(vessel_direction(tree, {-1, 0.0}), Vec3(0, 0, 0));
    EXPECT_EQ(vessel_direction(tree, {1, 0.0}), Vec3(0, 0, 0));
}

}  // namespace
}  // namespace hepatica
