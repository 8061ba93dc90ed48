// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/pressed_stretches.h"

#include <gtest/gtest.h>

#include <numeric>

namespace hepatica {
namespace {

TEST(PressedStretches, AreWhereTheToolTouchesWithItsForceOverTheirArea) {
    std::vector<VertexPlace> places(6);
    for (int v = 0; v < 6; ++v)
        places[v] = {{.segment = v < 4 ? 2 : 5, .arclength_mm = 10.0 + 2.0 * v}, 3.0};
    const std::vector<double> areas(6, 0.5);
    ToolLoad load;
    EXPECT_TRUE(pressed_stretches(load, places, areas).empty());
    load.touched = {0, 1, 2, 3};
    EXPECT_TRUE(pressed_stretches(load, places, areas).empty()) << "it rests there";
    load.force_un = Vec3(0, 3000.0, 4000.0);
    auto pressed = pressed_stretches(load, places, areas);
    ASSERT_EQ(pressed.size(), 1u);
    EXPECT_EQ(pressed[0], (PressedStretch{2, 10.0, 16.0, 2500.0}));
    load.grip_un = 4000.0;  // with each jaw on half of it
    EXPECT_EQ(pressed_stretches(load, places, areas)[0].pressure_pa, 4000.0);
    load.touched.push_back(4);
    pressed = pressed_stretches(load, places, areas);
    ASSERT_EQ(pressed.size(), 2u);
    EXPECT_EQ(pressed[0].pressure_pa, 3200.0);
    EXPECT_EQ(pressed[1], (PressedStretch{5, 16.5, 19.5, 3200.0})) << "at least a radius";
}

TEST(PressedStretches, TheAreasOfVerticesAddUpToTheSurface) {
    const std::vector<Vec3> corners{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 3, 0), Vec3(2, 3, 0)};
    const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {1, 3, 2}};
    const std::vector<double> areas = vertex_areas_mm2(triangles, corners);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 6.0, 1e-12);
    EXPECT_NEAR(areas[0], 1.0, 1e-12);
    EXPECT_NEAR(areas[1], 2.0, 1e-12);
}

}  // namespace
}  // namespace hepatica
