// SPDX-License-Identifier: GPL-3.0-or-later
// The steps that find the liver, each on shapes whose answer is known: lobes and necks, parenchyma
// that changes from place to place, neighbours by their place, what is enclosed, borders.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/segmentation/enclosed_tissue.h"
#include "core/segmentation/liver_neighbours.h"
#include "core/segmentation/organ_border.h"
#include "core/segmentation/organ_lobes.h"
#include "core/segmentation/parenchyma.h"
#include "tests/support/test_masks.h"

namespace hepatica {
namespace {

Grid grid_of(int nx, int ny, int nz, double spacing_mm) {
    Grid grid;
    grid.dims = {nx, ny, nz};
    grid.spacing_mm = Vec3::Constant(spacing_mm);
    return grid;
}

bool in_ball(const Vec3& p, const Vec3& centre, double radius) {
    return (p - centre).norm() < radius;
}

// Balls of 30 and 18 mm, 70 mm apart, and a rod of 9 mm in radius between them.
Mask dumbbell() {
    return test::mask_where(grid_of(80, 40, 40, 2.0), [](const Vec3& p) {
        return in_ball(p, {40, 40, 40}, 30) || in_ball(p, {110, 40, 40}, 18) ||
               (p.x() > 40 && p.x() < 110 && std::hypot(p.y() - 40, p.z() - 40) < 9);
    });
}

TEST(OrganLobes, ArePartedAtTheNeckAndHangOnTheDeepest) {
    Job job;
    const Lobes found = lobes_of(dumbbell(), job);
    ASSERT_EQ(found.lobes.size(), 2u);
    const std::size_t large = found.lobes[0].depth_mm > found.lobes[1].depth_mm ? 0 : 1;
    const Lobe& small = found.lobes[1 - large];
    EXPECT_EQ(found.lobes[large].parent, -1);
    EXPECT_EQ(small.parent, static_cast<int>(large));
    EXPECT_NEAR(found.lobes[large].depth_mm, 30.0, 2.0);
    EXPECT_NEAR(small.depth_mm, 18.0, 2.0);
    EXPECT_NEAR(small.neck_mm, 9.0, 2.0);
    EXPECT_NEAR(small.centre_mm.y(), 40.0, 1.0);
    EXPECT_EQ(found.labels.at(20, 20, 20), large + 1);
    EXPECT_EQ(found.labels.at(55, 20, 20), 2 - large);
    EXPECT_EQ(found.labels.at(20, 2, 2), 0u);
    std::size_t voxels = 0;
    for (const Lobe& lobe : found.lobes) voxels += lobe.voxels;
    EXPECT_EQ(voxels, found.labels.voxels.size() -
                          static_cast<std::size_t>(std::count(found.labels.voxels.begin(),
                                                              found.labels.voxels.end(), 0u)));
}

TEST(OrganLobes, ABallAndARodAreOneEach) {
    Job job;
    const Grid grid = grid_of(60, 30, 30, 2.0);
    const Vec3 middle(60, 29, 29);
    const auto ball = test::mask_where(grid, [&](const Vec3& p) { return in_ball(p, middle, 25); });
    EXPECT_EQ(lobes_of(ball, job).lobes.size(), 1u);
    const auto rod = test::mask_where(grid, [](const Vec3& p) {
        return p.x() > 10 && p.x() < 110 && std::hypot(p.y() - 29, p.z() - 29) < 12;
    });
    EXPECT_EQ(lobes_of(rod, job).lobes.size(), 1u);
    EXPECT_TRUE(lobes_of(Mask(grid), job).lobes.empty());
    job.cancel();
    EXPECT_THROW(lobes_of(ball, job), Cancelled);
}

// Two balls that run into each other: at a neck that is nearly as deep as the smaller, or by less
// than two millimetres, they are one lobe.
TEST(OrganLobes, AreNotPartedWhereTheNeckIsHardlyOne) {
    const auto lobes = [](double large, double small, double neck) {
        const Vec3 first = Vec3::Constant(large + 3.0);
        const double apart =
            std::sqrt(large * large - neck * neck) + std::sqrt(small * small - neck * neck);
        const int across = static_cast<int>(2.0 * large) + 6;
        const Mask body = test::mask_where(
            grid_of(static_cast<int>(apart + large + small) + 6, across, across, 1.0),
            [&](const Vec3& p) {
                return in_ball(p, first, large) || in_ball(p, first + Vec3(apart, 0, 0), small);
            });
        Job job;
        return lobes_of(body, job).lobes.size();
    };
    EXPECT_EQ(lobes(40.0, 38.0, 35.4), 1u) << "0.93 of the smaller's depth";
    EXPECT_EQ(lobes(40.0, 38.0, 31.0), 2u) << "0.82 of it";
    EXPECT_EQ(lobes(20.0, 9.0, 7.4), 1u) << "1.6 mm below the smaller's depth";
    EXPECT_EQ(lobes(20.0, 9.0, 5.5), 2u) << "3.5 mm below it";
}

// The lobe of a dumbbell at four places about the seat, as seen from its larger ball.
TEST(LiverNeighbours, AreLobesBehindOrBelowOnTheLeftOrHighAbove) {
    const auto taken = [](const Vec3& towards, double distance_mm) {
        const Vec3 seat_mm(110, 110, 110);
        const Vec3 lobe_mm = seat_mm + distance_mm * towards.normalized();
        const Mask region = test::mask_where(grid_of(74, 74, 74, 3.0), [&](const Vec3& p) {
            const double along =
                std::clamp((p - seat_mm).dot(towards.normalized()), 0.0, distance_mm);
            const Vec3 axis = seat_mm + along * towards.normalized();
            return in_ball(p, seat_mm, 42) || in_ball(p, lobe_mm, 24) || (p - axis).norm() < 12;
        });
        const Mask seat =
            test::mask_where(region.grid, [&](const Vec3& p) { return in_ball(p, seat_mm, 40); });
        Job job;
        const Mask found = neighbours_in(region, Mask(region.grid), seat, job);
        EXPECT_EQ(value_at(found, seat_mm), 0);
        return value_at(found, lobe_mm) != 0;
    };
    EXPECT_TRUE(taken({1, 0.6, -0.3}, 80));    // spleen
    EXPECT_TRUE(taken({0.5, -0.3, 1}, 80));    // heart
    EXPECT_FALSE(taken({1, -0.3, 0.4}, 80));   // left lobe
    EXPECT_FALSE(taken({-1, 0.6, -0.3}, 80));  // the right lobe's own
}

TEST(LiverNeighbours, AreThinPartsBelowOnTheLeft) {
    const Vec3 seat_mm(80, 90, 110);
    const auto tongue = [&](double up_mm) {
        const Mask region = test::mask_where(grid_of(74, 60, 60, 3.0), [&](const Vec3& p) {
            const Vec3 q = p - seat_mm;
            return q.norm() < 60 ||
                   (q.x() > 0 && q.x() < 110 && std::hypot(q.y(), q.z() - up_mm) < 10);
        });
        Job job;
        const Mask seat =
            test::mask_where(region.grid, [&](const Vec3& p) { return in_ball(p, seat_mm, 40); });
        return value_at(neighbours_in(region, Mask(region.grid), seat, job),
                        seat_mm + Vec3(85, 0, up_mm)) != 0;
    };
    EXPECT_TRUE(tongue(-40));  // pancreas
    EXPECT_FALSE(tongue(40));  // a thin left lobe
}

// 100 HU on one side, 70 on the other: the field between is followed, a neighbour of 70 HU behind a
// film of fat is not.
TEST(Parenchyma, FollowsAFieldButNoStep) {
    const Grid grid = grid_of(70, 40, 40, 3.0);
    FloatVolume smooth(grid, -100.0f);
    Mask seat(grid);
    for (std::size_t i = 0; i < smooth.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        if (std::hypot(p.y() - 60, p.z() - 60) > 45) continue;
        if (p.x() > 15 && p.x() < 135)
            smooth.voxels[i] =
                static_cast<float>(100.0 - 30.0 / (1.0 + std::exp((90 - p.x()) / 8)));
        if (p.x() > 142 && p.x() < 195) smooth.voxels[i] = 70.0f;
        seat.voxels[i] = in_ball(p, {50, 60, 60}, 30);
    }
    Job job;
    const Parenchyma grown = grow_parenchyma(smooth, seat, job);
    EXPECT_EQ(value_at(grown.voxels, Vec3(50, 60, 60)), 1);
    EXPECT_EQ(value_at(grown.voxels, Vec3(125, 60, 60)), 1);
    EXPECT_EQ(value_at(grown.voxels, Vec3(165, 60, 60)), 0);
    EXPECT_NEAR(value_at(grown.hu, Vec3(40, 60, 60)), 100.0f, 2.0f);
    EXPECT_NEAR(value_at(grown.hu, Vec3(125, 60, 60)), 70.0f, 4.0f);
    job.cancel();
    EXPECT_THROW(grow_parenchyma(smooth, seat, job), Cancelled);
}

// Nothing is wider than a neck: the seat is all that is sure.
TEST(Parenchyma, OfAnOrganAsThinAsANeckIsItsSeat) {
    const Grid grid = grid_of(30, 30, 30, 2.0);
    FloatVolume smooth(grid, -100.0f);
    Mask seat(grid);
    for (std::size_t i = 0; i < smooth.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        if (!in_ball(grid.to_mm(x, y, z), Vec3::Constant(29), 6)) continue;
        smooth.voxels[i] = 100.0f;
        seat.voxels[i] = 1;
    }
    Job job;
    EXPECT_EQ(grow_parenchyma(smooth, seat, job).voxels.voxels, seat.voxels);
}

TEST(Seat, IsTheDeepestPart) {
    Job job;
    const Mask body = dumbbell();
    const Mask seat = seat_of(body, job);
    EXPECT_EQ(value_at(seat, Vec3(40, 40, 40)), 1);
    EXPECT_EQ(value_at(seat, Vec3(110, 40, 40)), 0);
    for (std::size_t i = 0; i < seat.voxels.size(); ++i) {
        ASSERT_TRUE(seat.voxels[i] == 0 || body.voxels[i] != 0);
    }
    const Mask all(body.grid, 1);
    EXPECT_EQ(seat_of(all, job).voxels, all.voxels);
}

// A tumour inside of a ball of tissue, one that lies half in the fat, and a plain of muscle beside.
TEST(EnclosedTissue, IsWhatMostWaysOutMeetTheOrgan) {
    const Grid grid = grid_of(60, 50, 50, 3.0);
    const Vec3 middle(75, 75, 75), beside(75, 128, 75);
    FloatVolume smooth(grid, -100.0f);
    Mask organ(grid);
    for (std::size_t i = 0; i < smooth.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        const bool tumour = in_ball(p, middle, 20) || in_ball(p, beside, 14);
        organ.voxels[i] = in_ball(p, middle, 50) && !tumour;
        if (organ.voxels[i] != 0) smooth.voxels[i] = 110.0f;
        if (tumour) smooth.voxels[i] = 50.0f;
        if (p.x() > 140) smooth.voxels[i] = 60.0f;
    }
    Job job;
    const Mask found = enclosed_tissue(smooth, organ, job);
    EXPECT_EQ(value_at(found, middle), 1);
    EXPECT_EQ(value_at(found, middle + Vec3(12, 0, 0)), 1);
    EXPECT_EQ(value_at(found, Vec3(75, 138, 75)), 0);
    EXPECT_EQ(value_at(found, Vec3(165, 75, 75)), 0);
    EXPECT_EQ(value_at(found, middle + Vec3(40, 0, 0)), 0);  // the organ itself
}

// Nine of the 26 ways lead out through one side: the other 17 are 65 of 100. With the opposite side
// open as well eight are left.
TEST(EnclosedTissue, MayLieOpenToOneSideWhicheverItIsButNotToTwo) {
    const Grid grid = grid_of(50, 50, 50, 3.0);
    const Vec3 middle(75, 75, 75);
    for (int axis = 0; axis < 3; ++axis)
        for (const int open : {-1, 1, 2}) {
            FloatVolume smooth(grid, -100.0f);
            Mask organ(grid);
            for (std::size_t i = 0; i < organ.voxels.size(); ++i) {
                const auto [x, y, z] = grid.index_of(i);
                const Vec3 p = grid.to_mm(x, y, z);
                const double along = p[axis] - middle[axis];
                const bool tumour = in_ball(p, middle, 20);
                const bool away = (open == 2 ? std::abs(along) : open * along) > 10.0;
                organ.voxels[i] = in_ball(p, middle, 50) && !tumour && !away;
                if (tumour) smooth.voxels[i] = 50.0f;
                if (organ.voxels[i] != 0) smooth.voxels[i] = 110.0f;
            }
            Job job;
            EXPECT_EQ(value_at(enclosed_tissue(smooth, organ, job), middle), open == 2 ? 0 : 1)
                << "axis " << axis << ", open " << open;
        }
}

// A body that the scan cuts off above, stored by axial slices and by coronal ones.
TEST(EnclosedTissue, IsTheSameWhicheverWayTheSlicesWereStored) {
    const Vec3 tumour(78, 60, 58), liver(60, 60, 55);
    const auto found_in = [&](const Grid& grid) {
        FloatVolume smooth(grid, -100.0f);
        Mask organ(grid);
        for (std::size_t i = 0; i < organ.voxels.size(); ++i) {
            const auto [x, y, z] = grid.index_of(i);
            const Vec3 p = grid.to_mm(x, y, z);
            const bool in_tumour = in_ball(p, tumour, 22);
            organ.voxels[i] = in_ball(p, liver, 40) && !in_tumour;
            if (in_tumour) smooth.voxels[i] = 50.0f;
            if (organ.voxels[i] != 0) smooth.voxels[i] = 110.0f;
        }
        Job job;
        return enclosed_tissue(smooth, organ, job);
    };
    const Mask axial = found_in(grid_of(40, 40, 24, 3.0));
    Grid across = grid_of(40, 24, 40, 3.0);
    across.direction.col(1) = Vec3::UnitZ();
    across.direction.col(2) = Vec3::UnitY();
    const Mask coronal = found_in(across);
    EXPECT_GT(std::count(axial.voxels.begin(), axial.voxels.end(), 1), 1000);
    for (std::size_t i = 0; i < axial.voxels.size(); ++i) {
        const auto [x, y, z] = axial.grid.index_of(i);
        ASSERT_EQ(axial.voxels[i], coronal.at(x, z, y)) << x << " " << y << " " << z;
    }
}

// As a vessel is: the thinnest width is that of organ and piece together.
TEST(EnclosedTissue, MayBeThinBetweenWallsOfTheOrgan) {
    const Grid grid = grid_of(50, 50, 50, 3.0);
    const Vec3 middle(75, 75, 75);
    FloatVolume smooth(grid, -100.0f);
    Mask organ(grid);
    for (std::size_t i = 0; i < organ.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        const bool thin = in_ball(p, middle, 20) && std::abs(p.x() - middle.x()) < 2.0;
        organ.voxels[i] = in_ball(p, middle, 50) && !thin;
        if (in_ball(p, middle, 50)) smooth.voxels[i] = thin ? 180.0f : 110.0f;
    }
    Job job;
    EXPECT_EQ(value_at(enclosed_tissue(smooth, organ, job), middle), 1);
}

// Nothing is known of a slab between inside and outside: the border lies where a surface is cheap.
TEST(OrganBorder, RunsWhereTheImageHasAnEdge) {
    const Grid grid = grid_of(40, 16, 16, 2.0);
    Job job;
    for (const int edge_at : {14, 24}) {
        BorderCost cost{FloatVolume(grid), FloatVolume(grid, 1.0f)};
        Mask start(grid);
        for (std::size_t i = 0; i < start.voxels.size(); ++i) {
            const int x = grid.index_of(i)[0];
            start.voxels[i] = x < 19;
            if (x < 10) cost.inside.voxels[i] = -2.0f;
            if (x >= 30) cost.inside.voxels[i] = 2.0f;
            if (x == edge_at) cost.area.voxels[i] = 0.05f;
        }
        const Mask found = fit_border(cost, start, 300, job);
        for (int x = 0; x < grid.dims[0]; ++x)
            EXPECT_EQ(found.at(x, 8, 8), x <= edge_at ? 1 : 0) << x << ", edge at " << edge_at;
    }
}

TEST(OrganBorder, CutsALobeThatCostsBehindItsNeck) {
    const Mask body = dumbbell();
    BorderCost cost{FloatVolume(body.grid, 1.0f), FloatVolume(body.grid, 1.0f)};
    for (std::size_t i = 0; i < body.voxels.size(); ++i)
        if (body.voxels[i] != 0)
            cost.inside.voxels[i] = body.grid.index_of(i)[0] > 44 ? 0.3f : -0.6f;
    Job job;
    const Mask found = fit_border(cost, body, 120, job);
    EXPECT_EQ(found.at(20, 20, 20), 1);
    EXPECT_EQ(found.at(55, 20, 20), 0);
    job.cancel();
    EXPECT_THROW(fit_border(cost, body, 120, job), Cancelled);
}

}  // namespace
}  // namespace hepatica
