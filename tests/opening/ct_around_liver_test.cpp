// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/opening/ct_around_liver.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"

namespace hepatica {
namespace {

// Air, with a liver of 100 HU in a box.
class CtAroundLiver : public ::testing::Test {
  protected:
    CtAroundLiver() {
        Grid grid;
        grid.dims = {100, 90, 60};
        grid.spacing_mm = Vec3(2.0, 2.0, 4.0);
        grid.origin_mm = Vec3(-100, -90, 500);
        ct_ = Volume(grid, -1000);
        organs_ = Mask(grid);
        for (int z = 25; z < 35; ++z)
            for (int y = 40; y < 55; ++y)
                for (int x = 30; x < 60; ++x) {
                    ct_.at(x, y, z) = 100;
                    organs_.at(x, y, z) = organ_label::liver;
                }
    }
    Volume around(const Mask& organs) { return ct_around_liver(ct_, patient_, organs, job_); }

    Volume ct_;
    Mask organs_;
    PatientCase patient_;
    Job job_;
};

TEST_F(CtAroundLiver, HoldsTheLiverWithAMarginAndNoMore) {
    const Volume drawn = around(organs_);
    ASSERT_FALSE(drawn.voxels.empty());
    EXPECT_NEAR(drawn.grid.spacing_mm.x(), 1.25, 1e-9);
    EXPECT_NEAR(drawn.grid.spacing_mm.z(), 1.25, 1e-9);
    const Vec3 lower = ct_.grid.to_mm(30, 40, 25), upper = ct_.grid.to_mm(59, 54, 34);
    const Vec3 first = drawn.grid.to_mm(0, 0, 0);
    const Vec3 last =
        drawn.grid.to_mm(drawn.grid.dims[0] - 1, drawn.grid.dims[1] - 1, drawn.grid.dims[2] - 1);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(first[axis], lower[axis] - 30.0, 5.0);
        EXPECT_NEAR(last[axis], upper[axis] + 30.0, 5.0);
    }
    EXPECT_NEAR(value_at(drawn, 0.5 * (lower + upper)), 100, 2);
    EXPECT_EQ(value_at(drawn, lower - Vec3::Constant(15.0)), -1000);
}

TEST_F(CtAroundLiver, LooksForTheVesselsWhereNoLiverIsKnown) {
    EXPECT_TRUE(around({}).voxels.empty()) << "neither is known";
    VesselSegment vessel;
    vessel.points_mm = {ct_.grid.to_mm(45, 45, 28), ct_.grid.to_mm(45, 45, 32)};
    vessel.radii_mm = {3.0, 3.0};
    patient_.tree.segments = {vessel};
    const Volume drawn = around({});
    ASSERT_FALSE(drawn.voxels.empty());
    EXPECT_TRUE(holds(drawn.grid, vessel.points_mm[0] + Vec3(40, 40, -40)));
    EXPECT_EQ(around(Mask(ct_.grid)).voxels, drawn.voxels) << "organs without a liver";
}

TEST_F(CtAroundLiver, IsEmptyBesideTheCt) {
    Mask elsewhere = organs_;
    elsewhere.grid.origin_mm += Vec3(0, 0, 5000);
    EXPECT_TRUE(around(elsewhere).voxels.empty());
}

TEST_F(CtAroundLiver, HasAtMost256VoxelsAlongAnAxis) {
    ct_.grid.spacing_mm = Vec3(8.0, 2.0, 4.0);
    std::fill(organs_.voxels.begin(), organs_.voxels.end(), organ_label::liver);
    organs_.grid = ct_.grid;
    const Volume drawn = around(organs_);
    EXPECT_LE(*std::max_element(drawn.grid.dims.begin(), drawn.grid.dims.end()), 256);
    EXPECT_GE(drawn.grid.dims[0], 250);
    EXPECT_NEAR(drawn.grid.spacing_mm.x(), drawn.grid.spacing_mm.y(), 1e-9);
}

TEST_F(CtAroundLiver, HearsACancel) {
    job_.cancel();
    EXPECT_THROW(around(organs_), Cancelled);
}

}  // namespace
}  // namespace hepatica
