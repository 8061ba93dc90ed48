// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/frame.h"

#include <gtest/gtest.h>

namespace hepatica {
namespace {

TEST(Frame, KnowsThePlacesOfItsVerticesAndTheBoxAroundThem) {
    Frame frame;
    frame.positions_mm = {1, -2, 3, -4, 5, 6, 0, 0, -0.5F};
    EXPECT_EQ(frame.place_mm(1), Vec3(-4, 5, 6));
    EXPECT_EQ(frame.place_mm(2), Vec3(0, 0, -0.5));
    const auto [low, high] = frame.box_mm();
    EXPECT_EQ(low, Vec3(-4, -2, -0.5));
    EXPECT_EQ(high, Vec3(1, 5, 6));
}

}  // namespace
}  // namespace hepatica
