// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/tree_extraction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "core/accuracy/accuracy.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/filters.h"
#include "core/phantom/phantom.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "tests/support/test_masks.h"
#include "tests/support/test_trees.h"

namespace hepatica {

using namespace test;

namespace {

VesselTree tree_of(const Mask& mask, const Volume* ct = nullptr, const TreeOptions& options = {}) {
    Job job;
    const Mask skeleton = unit_width(thin(mask, ThinningMethod::queue, job), job);
    return extract_tree(skeleton, mask, ct, options, job);
}

double distance_to_stretch(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - share * (b - a)).norm();
}

// A tube of the given radius from a to b with round ends.
auto tube(const Vec3& a, const Vec3& b, double radius) {
    return [=](const Vec3& p) { return distance_to_stretch(p, a, b) < radius; };
}

// A Y in the plane z = 20: a trunk along y that parts into two branches.
Mask y_mask(double spacing_mm = 0.8) {
    Grid grid;
    grid.spacing_mm = Vec3::Constant(spacing_mm);
    for (int a = 0; a < 3; ++a) grid.dims[a] = static_cast<int>((a == 2 ? 40 : 64) / spacing_mm);
    const Vec3 fork(30, 30, 20);
    const auto trunk = tube(Vec3(30, 4, 20), fork, 4.0);
    const auto left = tube(fork, Vec3(10, 58, 20), 2.5);
    const auto right = tube(fork, Vec3(52, 56, 20), 3.2);
    return mask_where(grid, [&](const Vec3& p) { return trunk(p) || left(p) || right(p); });
}

}  // namespace

//     left   right      one bifurcation, three ends, the trunk is the root
//        \   /
//         \ /
//          |
TEST(TreeExtraction, ForkHasOneBifurcationAndItsTrunkIsTheRoot) {
    const VesselTree tree = tree_of(y_mask());
    validate(tree);
    ASSERT_EQ(tree.segments.size(), 3u);
    EXPECT_EQ(bifurcation_count(tree), 1);
    EXPECT_EQ(end_count(tree), 3);
    EXPECT_EQ(roots(tree), std::vector<int>{0});
    EXPECT_EQ(tree.segments[1].parent, 0);
    EXPECT_EQ(tree.segments[2].parent, 0);
    EXPECT_EQ(tree.segments[0].strahler_order, 2);
    EXPECT_LT((tree.segments[0].points_mm.back() - Vec3(30, 30, 20)).norm(), 2.5);
    EXPECT_LT(tree.segments[0].points_mm.front().y(), 8.0);
}

// Also from the fork, which is nearer to the last of these places than any end.
TEST(TreeExtraction, BeginsAtTheEndNearestToTheWishedPlace) {
    const Vec3 trunk(30, 4, 20), left(10, 58, 20), right(52, 56, 20);
    for (const auto& [wish, end] : {std::pair{trunk, trunk},
                                    {left, left},
                                    {right, right},
                                    {Vec3(12, 57, 21), left},
                                    {Vec3(34, 33, 20), trunk}}) {
        TreeOptions options;
        options.roots_mm = {wish};
        const VesselTree tree = tree_of(y_mask(), nullptr, options);
        ASSERT_EQ(roots(tree).size(), 1U) << wish.transpose();
        EXPECT_LT((tree.segments[roots(tree)[0]].points_mm.front() - end).norm(), 5.0)
            << wish.transpose();
    }
}

TEST(TreeExtraction, RadiiOfAForkAreThoseItWasDrawnWith) {
    const VesselTree tree = tree_of(y_mask());
    ASSERT_EQ(tree.segments.size(), 3u);
    // Far enough from the fork and from the round ends each branch has its own radius.
    for (const VesselSegment& segment : tree.segments) {
        const std::size_t middle = segment.radii_mm.size() * 6 / 10;
        const double x = segment.points_mm[middle].x();
        const double expected = std::abs(x - 30.0) < 1.5 ? 4.0 : x < 30.0 ? 2.5 : 3.2;
        EXPECT_NEAR(segment.radii_mm[segment.parent < 0 ? segment.radii_mm.size() / 2 : middle],
                    expected, 0.16)
            << "at x = " << x;
    }
}

// The sections of a thin branch that lie in the trunk's lumen are the trunk's.
TEST(TreeExtraction, AThinBranchDoesNotBeginAsWideAsItsParent) {
    Grid grid;
    grid.spacing_mm = Vec3::Constant(0.8);
    grid.dims = {70, 80, 40};
    const auto trunk = tube(Vec3(16, 6, 16), Vec3(16, 58, 16), 6.5);
    const auto branch = tube(Vec3(16, 30, 16), Vec3(50, 38, 16), 2.0);
    const VesselTree tree =
        tree_of(mask_where(grid, [&](const Vec3& p) { return trunk(p) || branch(p); }));
    ASSERT_EQ(tree.segments.size(), 3u);
    int thin = 0;
    for (const VesselSegment& segment : tree.segments) {
        if (segment.points_mm.back().x() < 40.0) continue;
        ++thin;
        EXPECT_LT(segment.points_mm.front().x(), 22.0);
        for (const double r : segment.radii_mm) EXPECT_NEAR(r, 2.0, 0.3);
    }
    EXPECT_EQ(thin, 1);
}

// Portal and hepatic veins that touch are one graph: each thin branch must be measured by the
// contrast of its own trunk, not by that of both.
TEST(TreeExtraction, RadiiComeFromTheContrastOfTheTrunkNearby) {
    Grid grid;
    grid.spacing_mm = Vec3::Constant(0.65);
    grid.dims = {120, 62, 62};
    constexpr double thin_mm = 1.3;
    const auto bright_trunk = tube(Vec3(4, 12, 10), Vec3(74, 12, 10), 3.0);
    const auto bright_branch = tube(Vec3(20, 12, 10), Vec3(20, 12, 36), thin_mm);
    const auto dim_trunk = tube(Vec3(4, 28, 10), Vec3(74, 28, 10), 3.0);
    const auto dim_branch = tube(Vec3(60, 28, 10), Vec3(60, 28, 36), thin_mm);
    const auto touch = tube(Vec3(40, 12, 10), Vec3(40, 28, 10), 1.5);
    const auto is_bright = [&](const Vec3& p) { return bright_trunk(p) || bright_branch(p); };
    const auto is_dim = [&](const Vec3& p) { return dim_trunk(p) || dim_branch(p) || touch(p); };
    const Mask mask = mask_where(grid, [&](const Vec3& p) { return is_bright(p) || is_dim(p); });
    Job job;
    FloatVolume scan(grid, 100.0f);
    for (std::size_t i = 0; i < scan.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        int bright = 0, dim = 0;  // of 27 places in the voxel
        for (int k = 0; k < 27; ++k) {
            const Vec3 place =
                grid.to_mm(Vec3(at[0] + (k % 3 - 1) / 3.0, at[1] + (k / 3 % 3 - 1) / 3.0,
                                at[2] + (k / 9 - 1) / 3.0));
            if (is_bright(place))
                ++bright;
            else if (is_dim(place))
                ++dim;
        }
        scan.voxels[i] += static_cast<float>(80.0 * bright / 27.0 + 40.0 * dim / 27.0);
    }
    gaussian_smooth(scan, Vec3::Constant(0.6), job);
    Volume ct(grid);
    for (std::size_t i = 0; i < ct.voxels.size(); ++i)
        ct.voxels[i] = static_cast<std::int16_t>(std::lround(scan.voxels[i]));

    const VesselTree tree = tree_of(mask, &ct);
    int branches = 0;
    for (const VesselSegment& segment : tree.segments) {
        const std::size_t middle = segment.points_mm.size() / 2;
        if (segment.points_mm[middle].z() < 18.0) continue;
        ++branches;
        EXPECT_NEAR(segment.radii_mm[middle], thin_mm, 0.08)
            << "at x = " << segment.points_mm[middle].x();
    }
    EXPECT_EQ(branches, 2);
}

TEST(TreeExtraction, CentrelineIsSmoothAndAboutAVoxelFromPointToPoint) {
    const VesselTree tree = tree_of(y_mask());
    for (const VesselSegment& segment : tree.segments)
        for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
            const double gap = (segment.points_mm[i] - segment.points_mm[i - 1]).norm();
            EXPECT_GT(gap, 0.3);
            EXPECT_LT(gap, 1.6);
        }
}

TEST(TreeExtraction, RingIsKeptAndMarked) {
    const VesselTree tree = tree_of(torus_mask());
    validate(tree);
    ASSERT_EQ(tree.segments.size(), 2u);
    EXPECT_FALSE(tree.segments[0].closes_loop);
    EXPECT_TRUE(tree.segments[1].closes_loop);
    EXPECT_NEAR(length_mm(tree), 2.0 * 3.14159 * 10.0, 4.0);
}

// The numbers of systems say nothing of where a wall lies.
TEST(TreeExtraction, RadiiDoNotDependOnTheNumberOfTheSystem) {
    Mask mask = y_mask();
    const VesselTree portal = tree_of(mask);
    for (std::uint8_t& voxel : mask.voxels)
        if (voxel != 0) voxel = 255;
    VesselTree unknown = tree_of(mask);
    for (VesselSegment& segment : unknown.segments) {
        EXPECT_EQ(segment.system, VascularSystem::unknown);
        segment.system = VascularSystem::portal;
        segment.system_confidence = 1.0;
    }
    expect_equal(unknown, portal);
}

// A long vessel, a short one beside it and a seed in the short one.
TEST(TreeExtraction, AShortPieceStaysWhereASeedLiesInIt) {
    const auto longer = tube(Vec3(10, 10, 10), Vec3(10, 50, 10), 3.0);
    const auto shorter = tube(Vec3(50, 10, 10), Vec3(50, 20, 10), 3.0);
    Grid grid;
    grid.dims = {60, 60, 20};
    Mask mask(grid);
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        const Vec3 p = grid.to_mm(x, y, z);
        mask.voxels[i] = longer(p) ? 1 : shorter(p) ? 255 : 0;
    }
    Job job;
    const Mask skeleton = unit_width(thin(mask, ThinningMethod::queue, job), job);
    const auto extracted = [&](const std::vector<VesselSeed>& seeds) {
        TreeOptions options;
        options.seeds = seeds;
        return extract_tree_and_bridges(skeleton, mask, nullptr, options, job);
    };
    const TreeExtraction without = extracted({});
    EXPECT_EQ(roots(without.tree).size(), 1u);
    EXPECT_EQ(without.too_short.count, 1);
    EXPECT_NEAR(without.too_short.length_mm, 10.0, 4.0);
    EXPECT_EQ(without.tree.segments.at(0).system, VascularSystem::portal);
    EXPECT_EQ(without.tree.segments.at(0).system_confidence, 1.0);

    const VesselSeed in_short{Vec3(50, 15, 10)}, in_long{Vec3(10, 30, 10), VascularSystem::portal};
    const TreeExtraction both = extracted({in_long, in_short});
    EXPECT_EQ(roots(both.tree).size(), 2u);
    EXPECT_EQ(both.too_short.count, 0);
    EXPECT_EQ(both.tree.segments.at(1).system, VascularSystem::unknown);
}

TEST(TreeExtraction, NothingBecomesAnEmptyTree) {
    EXPECT_TRUE(tree_of(Mask(cube_grid(5))).segments.empty());
}

TEST(TreeExtraction, RefusesMasksOfDifferentGrids) {
    Job job;
    EXPECT_THROW(extract_tree(Mask(cube_grid(5)), Mask(cube_grid(6)), nullptr, {}, job),
                 InputError);
}

// Noise that is taken for vessels: parallel lines, 46 m of them; of half as many a tree is made.
TEST(TreeExtraction, RefusesVesselsLongerThanALiverShows) {
    Job job;
    const auto lines = [](int every) {
        Grid grid;
        grid.dims = {260, 13, 13};
        grid.spacing_mm = Vec3::Constant(5.0);
        Mask mask(grid);
        for (int z = 1; z < 13; z += 2)
            for (int y = 1; y < 13; y += every)
                for (int x = 1; x < 259; ++x) mask.at(x, y, z) = 255;
        return mask;
    };
    TreeOptions options;
    options.find_systems = true;
    const Mask tangle = lines(2), sound = lines(4);
    try {
        extract_tree(tangle, tangle, nullptr, options, job);
        FAIL() << "was accepted";
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("46 m long"), std::string::npos) << error.problem();
    }
    EXPECT_NO_THROW(extract_tree(sound, sound, nullptr, options, job));
}

TEST(TreeExtraction, SameBytesForAnyNumberOfThreads) {
    const Mask mask = y_mask(1.5);
    const VesselTree whole = tree_of(mask);
    const ThreadLimit one(1);
    const VesselTree again = tree_of(mask);
    ASSERT_EQ(whole.segments.size(), again.segments.size());
    for (std::size_t s = 0; s < whole.segments.size(); ++s) {
        EXPECT_EQ(whole.segments[s].points_mm, again.segments[s].points_mm);
        EXPECT_EQ(whole.segments[s].radii_mm, again.segments[s].radii_mm);
    }
}

}  // namespace hepatica
