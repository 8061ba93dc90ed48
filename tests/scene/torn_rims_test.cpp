// SPDX-License-Identifier: GPL-3.0-or-later
// The rims of a bar of 3 x 3 cubes of 1 mm along x that is cut at x = 3 from its top downwards.
#include "core/scene/torn_rims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <span>

#include "core/scene/origins_of.h"
#include "tests/scene/cube_body.h"

namespace hepatica {
namespace {

struct BarCutAcross {
    BarCutAcross() {
        for (int x = 0; x < 6; ++x)
            for (int y = 0; y < 3; ++y)
                for (int z = 0; z < 3; ++z) body.add(x, y, 0, x + 0.5, z);
        tearing = std::make_unique<Tearing>(body.mesh, TearLaw{}, std::span<const double>{});
    }

    void cut_from_top(double depth) {
        const std::vector<int> joints =
            tearing->crossing(Vec3(3.0, 3.0 - depth, -1.0), Vec3(0, depth + 1.0, 0), Vec3(0, 0, 5),
                              body.rest_of(*tearing));
        ASSERT_FALSE(joints.empty());
        tearing->cut(joints);
    }

    // How many vertices are rims; all of them lie in the cut, not below this height.
    int rims_above(double least_y) const {
        const std::vector<std::uint8_t> rims = torn_rims(*tearing);
        const std::vector<Vec3> at = body.rest_of(*tearing);
        EXPECT_EQ(rims.size(), at.size());
        for (std::size_t v = 0; v < rims.size(); ++v) {
            if (rims[v] == 0) continue;
            EXPECT_EQ(at[v].x(), 3.0);
            EXPECT_GE(at[v].y(), least_y);
        }
        return static_cast<int>(std::ranges::count(rims, 1));
    }

    test::CubeBody body;
    std::unique_ptr<Tearing> tearing;
};

TEST(TornRims, OfAWholeBodyAreNone) {
    const BarCutAcross bar;
    EXPECT_EQ(bar.rims_above(0.0), 0);
}

// Both sides of the four vertices across the top; those below it still hang together.
TEST(TornRims, OfACutPartOfTheWayAreTheEdgesThatHaveParted) {
    BarCutAcross bar;
    bar.cut_from_top(1.0);
    ASSERT_EQ(bar.tearing->report().joints_broken, 0);
    ASSERT_EQ(bar.tearing->report().vertices_split, 4);
    EXPECT_EQ(bar.rims_above(3.0), 8);
}

TEST(TornRims, OfWhatTiesStillHoldAreNone) {
    BarCutAcross bar;
    bar.cut_from_top(1.0);
    TearState tied = bar.tearing->state();
    std::ranges::fill(tied.most_mm, 0.5 * TearLaw{}.softening().opening_mm);
    bar.tearing->restore(tied);
    ASSERT_GT(bar.tearing->report().joints_parted, 0);
    EXPECT_EQ(bar.rims_above(0.0), 0);
}

// One corner alone is no rim while nothing counts as torn.
TEST(TornRims, OfASingleCornerAreNone) {
    BarCutAcross bar;
    bar.cut_from_top(1.0);
    const std::vector<int> origins = origins_of(bar.tearing->topology());
    TearState tied = bar.tearing->state();
    const double half_mm = 0.5 * TearLaw{}.softening().opening_mm;
    // Nothing ties the pair at z = 1 any more; the others are bound.
    for (std::size_t i = 0; i < tied.parted.size(); ++i) {
        const Joint& joint =
            bar.tearing->topology().joints()[static_cast<std::size_t>(tied.parted[i])];
        for (int k = 0; k < 3; ++k) {
            const int v = bar.tearing->topology().sides(joint, k)[0];
            const int origin = origins[static_cast<std::size_t>(v)];
            if (bar.body.mesh.vertices_mm[static_cast<std::size_t>(origin)].z() != 1.0)
                tied.most_mm[3 * i + static_cast<std::size_t>(k)] = half_mm;
        }
    }
    bar.tearing->restore(tied);
    ASSERT_FALSE(bar.tearing->open_joints().empty());
    EXPECT_EQ(bar.rims_above(0.0), 0);
}

TEST(TornRims, OfADeeperCutAreAllThatHasComeApart) {
    BarCutAcross bar;
    bar.cut_from_top(2.0);
    ASSERT_GT(bar.tearing->report().joints_broken, 0);
    EXPECT_EQ(bar.rims_above(2.0), 16);
}

}  // namespace
}  // namespace hepatica
