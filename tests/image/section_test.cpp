// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hepatica {
namespace {

Grid cubes() {
    Grid grid;
    grid.dims = {60, 50, 40};
    grid.spacing_mm = Vec3::Constant(0.5);
    grid.origin_mm = Vec3(-7, 3, 20);
    return grid;
}

// A rod along x whose axis is at (y, z) on the grid above, between two planes.
void draw_rod(Mask& mask, double y, double z, double radius_mm, double from_x, double to_x) {
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const auto [ix, iy, iz] = mask.grid.index_of(i);
        const Vec3 p = mask.grid.to_mm(ix, iy, iz);
        if (std::hypot(p.y() - y, p.z() - z) < radius_mm && p.x() > from_x && p.x() < to_x)
            mask.voxels[i] = 1;
    }
}

TEST(Section, IsTheDiscAtWhichTheWidestRodIsCut) {
    Mask object(cubes()), beyond(cubes());
    draw_rod(object, 12, 30, 4.0, -7.1, 10.1);
    draw_rod(object, 21, 30, 2.0, -7.1, 10.1);
    draw_rod(beyond, 12, 30, 4.0, 10.1, 30);
    draw_rod(beyond, 21, 30, 2.0, 10.1, 30);
    const std::optional<Section> section = largest_section(object, beyond);
    ASSERT_TRUE(section);
    EXPECT_NEAR((section->middle_mm - Vec3(10, 12, 30)).norm(), 0.0, 0.1);
    // Voxels along the disc's border count whole or not at all.
    EXPECT_NEAR(section->area_mm2, std::numbers::pi * 16.0, 0.05 * std::numbers::pi * 16.0);
}

TEST(Section, IsNoneWhereNothingGoesOn) {
    Mask object(cubes()), beyond(cubes());
    draw_rod(object, 12, 30, 4.0, -7.1, 10.1);
    EXPECT_FALSE(largest_section(object, beyond));
    draw_rod(beyond, 12, 30, 4.0, 10.8, 30);  // one voxel is missing between them
    EXPECT_FALSE(largest_section(object, beyond));
    EXPECT_FALSE(largest_section(object, object));
}

}  // namespace
}  // namespace hepatica
