// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/segmentation/organ_surroundings.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace hepatica {
namespace {

// A ball of 30 mm in a medium whose upper half is something else. Oracle: by symmetry half of the
// shell lies in each.
TEST(OrganSurroundings, AreSharesOfTheShell) {
    Grid grid;
    grid.dims = {50, 50, 50};
    grid.spacing_mm = Vec3::Constant(2.0);
    Mask ball(grid);
    FloatVolume hu(grid);
    for (std::size_t i = 0; i < ball.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const double r = 2.0 * (Vec3(x, y, z) - Vec3::Constant(24.5)).norm();
        ball.voxels[i] = r < 30.0 ? 1 : 0;
        hu.voxels[i] = z >= 25 ? 700.0f : -800.0f;
    }
    Job job;
    const OrganSurroundings around = surroundings_of(ball, hu, job);
    EXPECT_NEAR(around.bone, 0.5, 1e-9);
    EXPECT_NEAR(around.lung, 0.5, 1e-9);
    const OrganSurroundings none = surroundings_of(Mask(grid, 1), hu, job);
    EXPECT_EQ(none.bone, 0.0);
}

// Of an organ of slopes alone no voxel is worth its border.
TEST(OrganSurroundings, OfNoOrganAreRefused) {
    Grid grid;
    grid.dims = {4, 4, 4};
    Job job;
    try {
        surroundings_of(Mask(grid), FloatVolume(grid), job);
        ADD_FAILURE() << "nothing was said";
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("no liver was found"), std::string::npos);
        EXPECT_NE(error.remedy().find("liver mask"), std::string::npos);
    }
}

TEST(OrganSurroundings, ABrainAndAHeartAreNamed) {
    EXPECT_NO_THROW(require_surroundings_of_liver({0.12, 0.3}));
    for (const auto& [around, word] :
         {std::pair{OrganSurroundings{0.5, 0.0}, "brain"}, {OrganSurroundings{0.1, 0.7}, "heart"}})
        try {
            require_surroundings_of_liver(around);
            ADD_FAILURE() << word;
        } catch (const InputError& error) {
            EXPECT_NE(error.problem().find(word), std::string::npos);
            EXPECT_NE(error.remedy().find("liver mask"), std::string::npos);
        }
}

}  // namespace
}  // namespace hepatica
