// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/accuracy/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/phantom/phantom.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "core/tree/tree_extraction.h"
#include "tests/support/test_masks.h"
#include "tests/support/test_trees.h"

namespace hepatica {

using namespace test;

namespace {

// Voxels of 1 mm that hold the tree of test_trees.h.
Mask mask_of(const VesselTree& tree) {
    Grid grid;
    grid.dims = {60, 75, 30};
    grid.origin_mm = Vec3(-25, -12, -15);
    return mask_where(grid, [&](const Vec3& p) {
        for (const VesselSegment& s : tree.segments)
            for (std::size_t i = 0; i < s.points_mm.size(); ++i)
                if ((s.points_mm[i] - p).norm() < s.radii_mm[i]) return true;
        return false;
    });
}

Accuracy compared(const VesselTree& tree, const Mask& mask) {
    Job job;
    return compare(tree, mask, forked_tree(), mask_of(forked_tree()), {}, job);
}

VesselTree moved(VesselTree tree, const Vec3& by_mm) {
    for (VesselNode& node : tree.nodes) node.position_mm += by_mm;
    for (VesselSegment& segment : tree.segments)
        for (Vec3& p : segment.points_mm) p += by_mm;
    return tree;
}

}  // namespace

TEST(Accuracy, TruthAgainstItselfIsPerfect) {
    const Accuracy a = compared(forked_tree(), mask_of(forked_tree()));
    EXPECT_DOUBLE_EQ(a.dice, 1.0);
    EXPECT_DOUBLE_EQ(a.cldice, 1.0);
    EXPECT_NEAR(a.centreline_mean_mm, 0.0, 1e-9);
    EXPECT_NEAR(a.radius_mae_mm.value(), 0.0,
                0.1);  // at forks the nearest branch may be the other one
    EXPECT_DOUBLE_EQ(a.length_found, 1.0);
    EXPECT_DOUBLE_EQ(a.bifurcation_recall, 1.0);
    EXPECT_DOUBLE_EQ(a.bifurcation_precision, 1.0);
    EXPECT_EQ(a.components, 1);
}

// A tube moved sideways by d has its centreline d away, and found while d is under the tolerance.
TEST(Accuracy, MovedTubeIsOffByItsMove) {
    VesselGraph graph;
    graph.nodes = {{Vec3(0, 0, 0), 3.0}, {Vec3(0, 50, 0), 3.0}};
    graph.links = {straight_link(graph, 0, 1, 3.0, 3.0)};
    const VesselTree truth = directed(graph);
    const Mask mask = mask_of(truth);
    Job job;
    for (const double d : {0.5, 1.5, 2.5}) {
        const Accuracy a = compare(moved(truth, Vec3(d, 0, 0)), mask, truth, mask, {}, job);
        EXPECT_NEAR(a.centreline_mean_mm, d, 1e-9);
        EXPECT_NEAR(a.centreline_p95_mm, d, 1e-9);
        EXPECT_NEAR(a.centreline_median_mm.value(), d, 1e-9);
        EXPECT_NEAR(a.truth_median_mm.value(), d, 1e-9);
        EXPECT_DOUBLE_EQ(a.length_found, d <= 2.0 ? 1.0 : 0.0);
    }
}

TEST(Accuracy, WiderRadiiShowAsBias) {
    VesselTree wide = forked_tree();
    for (VesselSegment& segment : wide.segments)
        for (double& r : segment.radii_mm) r += 0.4;
    const Accuracy a = compared(wide, mask_of(forked_tree()));
    EXPECT_NEAR(a.radius_bias_mm.value(), 0.4, 0.05);
    EXPECT_GE(a.radius_mae_mm.value(), std::abs(a.radius_bias_mm.value()));
}

// Dice of a mask that misses half of the voxels and has no others is 2/3.
TEST(Accuracy, DiceOfHalfAMask) {
    const Mask truth = mask_of(forked_tree());
    Mask half = truth;
    bool keep = false;
    for (auto& voxel : half.voxels)
        if (voxel != 0) voxel = (keep = !keep) ? 1 : 0;
    EXPECT_NEAR(compared(forked_tree(), half).dice, 2.0 / 3.0, 1e-3);
}

TEST(Accuracy, MaskOnAFinerGridIsComparedInSpace) {
    const Mask truth = mask_of(forked_tree());
    Mask fine;
    fine.grid = truth.grid;
    for (int a = 0; a < 3; ++a) fine.grid.dims[a] *= 2;
    fine.grid.spacing_mm /= 2.0;
    fine.grid.origin_mm -= Vec3::Constant(0.25);
    fine.voxels.resize(fine.grid.count());
    for (std::size_t i = 0; i < fine.voxels.size(); ++i) {
        const auto [x, y, z] = fine.grid.index_of(i);
        fine.voxels[i] = truth.at(x / 2, y / 2, z / 2);
    }
    const Accuracy a = compared(forked_tree(), fine);
    EXPECT_DOUBLE_EQ(a.dice, 1.0);
    EXPECT_GT(a.cldice, 0.99);
}

// The case's image ends at y = 20 mm, where the trunk forks; the truth goes on. The voxels of its
// last slice were repeated up to the end of the truth's grid.
TEST(Accuracy, AMaskSaysNothingBeyondItsOwnGrid) {
    const Mask truth = mask_of(forked_tree());
    Mask part;
    part.grid = truth.grid;
    part.grid.dims[1] = 12 + 21;  // up to y = 20 mm
    part.voxels.resize(part.grid.count());
    double both = 0.0, ours = 0.0, theirs = 0.0;
    for (std::size_t i = 0; i < part.voxels.size(); ++i) {
        const auto [x, y, z] = part.grid.index_of(i);
        part.voxels[i] = truth.at(x, y, z);
        ours += part.voxels[i];
    }
    for (std::size_t i = 0; i < truth.voxels.size(); ++i) {
        theirs += truth.voxels[i];
        both += truth.grid.index_of(i)[1] < part.grid.dims[1] ? truth.voxels[i] : 0.0;
    }
    ASSERT_LT(both, theirs);
    Job job;
    EXPECT_NEAR(dice_of(part, truth, job), 2.0 * both / (ours + theirs), 1e-12);
    EXPECT_EQ(dice_of(Mask(), truth, job), 0.0);
}

TEST(Accuracy, MissingAndInventedBranchesCostRecallAndPrecision) {
    VesselGraph graph = forked_graph();
    graph.links.resize(3);  // the second fork is missing
    graph.nodes.resize(4);
    const Accuracy missing = compared(directed(graph), mask_of(forked_tree()));
    EXPECT_DOUBLE_EQ(missing.bifurcation_recall, 0.5);
    EXPECT_DOUBLE_EQ(missing.bifurcation_precision, 1.0);
    EXPECT_LT(missing.length_found, 0.8);

    graph = forked_graph();
    graph.nodes.push_back({Vec3(-30, 40, 5), 2.0});
    graph.nodes.push_back({Vec3(-20, 45, 5), 2.0});
    graph.links.push_back(straight_link(graph, 2, 6, 2.0, 2.0));
    graph.links.push_back(straight_link(graph, 2, 7, 2.0, 2.0));
    const Accuracy invented = compared(directed(graph), mask_of(forked_tree()));
    EXPECT_DOUBLE_EQ(invented.bifurcation_recall, 1.0);
    EXPECT_NEAR(invented.bifurcation_precision, 2.0 / 3.0, 1e-12);
    EXPECT_GT(invented.centreline_mean_mm, 0.5);
}

TEST(Accuracy, EmptyTreeScoresNothingAndEmptyTruthIsRefused) {
    const Accuracy a = compared(VesselTree{}, Mask(mask_of(forked_tree()).grid));
    EXPECT_EQ(a.dice, 0.0);
    EXPECT_EQ(a.length_found, 0.0);
    EXPECT_EQ(a.bifurcation_recall, 0.0);
    EXPECT_EQ(a.bifurcation_precision, 0.0);
    EXPECT_TRUE(std::isnan(a.centreline_mean_mm));
    EXPECT_TRUE(std::isnan(a.centreline_p95_mm));
    EXPECT_FALSE(a.centreline_median_mm.has_value());
    EXPECT_FALSE(a.truth_median_mm.has_value());
    Job job;
    EXPECT_THROW(compare(forked_tree(), mask_of(forked_tree()), VesselTree{},
                         mask_of(forked_tree()), {}, job),
                 InputError);
}

// A tree that was drawn by hand has no voxels; memory before them was read.
TEST(Accuracy, ACaseWithoutVoxelsIsRefused) {
    EXPECT_THROW(compared(forked_tree(), Mask()), InputError);
}

// The chain from a perfect mask: what extraction itself contributes to the error.
TEST(Accuracy, TreeFromThePhantomsOwnMaskIsNearItsTruth) {
    for (const std::uint64_t seed : {1u, 2u}) {
        PhantomOptions options;
        options.seed = seed;
        Job job;
        const Phantom phantom = make_phantom(options, job);
        const Mask skeleton = unit_width(thin(phantom.vessels, ThinningMethod::queue, job), job);
        const VesselTree tree = extract_tree(skeleton, phantom.vessels, &phantom.ct, {}, job);
        validate(tree);
        const Accuracy a = compare(tree, phantom.vessels, phantom.tree, phantom.vessels, {}, job);
        EXPECT_LT(a.centreline_mean_mm, 0.35 * a.voxel_mm) << "seed " << seed;
        EXPECT_LT(std::abs(a.radius_bias_mm.value()), 0.1 * a.voxel_mm) << "seed " << seed;
        EXPECT_LT(a.radius_mae_mm.value(), 0.2 * a.voxel_mm) << "seed " << seed;
        EXPECT_GE(a.bifurcation_recall, 0.95) << "seed " << seed;
        EXPECT_GE(a.bifurcation_precision, 0.95) << "seed " << seed;
        EXPECT_EQ(a.components, 1) << "seed " << seed;
    }
}

}  // namespace hepatica
