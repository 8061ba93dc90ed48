// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/extraction/lumen_radius.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/test_masks.h"

namespace hepatica {
namespace {

using test::cube_grid;
using test::mask_where;

constexpr double radius = 4.0;
const Vec3 middle(20.15, 19.8, 20.0);  // beside the voxels, as a fitted axis is

double across(const Vec3& p) {
    return std::hypot(p.x() - middle.x(), p.y() - middle.y());
}

Grid half_millimetres() {
    Grid grid = cube_grid(81);
    grid.spacing_mm = Vec3::Constant(0.5);
    return grid;
}

// Along z through the middle.
Mask tube(double radius_mm) {
    return mask_where(half_millimetres(), [=](const Vec3& p) { return across(p) < radius_mm; });
}

// The same with a branch that leaves it along x.
Mask tube_with_branch(double branch_radius_mm) {
    return mask_where(half_millimetres(), [=](const Vec3& p) {
        const bool branch = p.x() > middle.x() &&
                            std::hypot(p.y() - middle.y(), p.z() - middle.z()) < branch_radius_mm;
        return across(p) < radius || branch;
    });
}

TEST(CrossSection, OfATubeIsADisc) {
    const CrossSection section = cross_section(tube(radius), nullptr, middle, Vec3::UnitZ(), 12.0);
    EXPECT_TRUE(section.inside);
    EXPECT_EQ(section.usable_share, 1.0);
    EXPECT_GT(section.roundness, 0.85);
    EXPECT_NEAR(std::sqrt(section.mask_area_mm2 / std::numbers::pi), radius, 0.1);
    EXPECT_LT(section.offset_mm.norm(), 0.1);
}

// Where another vessel leaves, the rays that run into it say nothing of this one.
TEST(CrossSection, RaysIntoABranchDoNotCount) {
    for (const double branch : {1.5, 2.5}) {
        const CrossSection section =
            cross_section(tube_with_branch(branch), nullptr, middle, Vec3::UnitZ(), 15.0);
        const double shadow = 2.0 * std::asin(branch / radius) / (2.0 * std::numbers::pi);
        EXPECT_LT(section.usable_share, 1.0);
        EXPECT_GE(section.usable_share, 1.0 - shadow - 0.03);
        EXPECT_NEAR(std::sqrt(section.mask_area_mm2 / std::numbers::pi), radius, 0.25);
        EXPECT_GT(section.roundness, 0.55);  // no ray that counts is 1.6 times the median and more
    }
}

// On a CT, what a neighbour adds beyond the wall belongs neither to the lumen nor to the tissue:
// here vessels lie around three quarters of the circle, a millimetre and a half off.
TEST(CrossSection, ANeighbourIsNoPartOfTheSurroundings) {
    const Mask mask = mask_where(half_millimetres(), [](const Vec3& p) {
        const Vec3 from = p - middle;
        const bool open = from.x() > std::abs(from.y());
        return across(p) < radius || (across(p) > radius + 1.5 && !open);
    });
    Volume ct(mask.grid);
    for (std::size_t i = 0; i < ct.voxels.size(); ++i)
        ct.voxels[i] = mask.voxels[i] != 0 ? 220.0F : 100.0F;
    const CrossSection section = cross_section(mask, &ct, middle, Vec3::UnitZ(), 12.0);
    ASSERT_TRUE(section.has_background);
    EXPECT_NEAR(section.background_hu, 100.0, 5.0);
    EXPECT_NEAR(section.centre_hu, 220.0, 1.0);
    const double excess = section.intensity - section.background_hu * section.covered_area_mm2;
    EXPECT_NEAR(std::sqrt(excess / 120.0 / std::numbers::pi), radius, 0.15);
}

}  // namespace
}  // namespace hepatica
