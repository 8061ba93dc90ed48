// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/territories/couinaud_segments.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "core/base/parallel.h"
#include "core/image/morphology.h"
#include "core/phantom/phantom.h"
#include "core/tree/systems/portal_trunk.h"
#include "tests/tree/territories/textbook_portal.h"

namespace hepatica {
namespace {

using test::PortalType;
using test::TextbookPatient;

const Mask& liver() {
    static const Mask mask = test::liver_of_phantom(3.0);
    return mask;
}

CouinaudSegments parted(const VesselTree& tree, const Mask& organ) {
    Job job;
    auto found = couinaud_segments(tree, organ, job);
    EXPECT_TRUE(found.has_value());
    return std::move(*found);
}

Phantom grown(std::uint64_t seed) {
    PhantomOptions options;
    options.seed = seed;
    options.systems = 2;
    options.generations = 5;
    options.dims = {72, 60, 56};
    options.spacing_mm = Vec3(3.0, 3.0, 3.0);
    Job job;
    return make_phantom(options, job);
}

class TextbookTest : public testing::TestWithParam<std::pair<PortalType, bool>> {};

// Oracle: every branch was drawn for a segment.
TEST_P(TextbookTest, EveryBranchHasTheSegmentThatItWasDrawnFor) {
    const auto [type, veins] = GetParam();
    const TextbookPatient patient = test::textbook_patient(type, veins, liver());
    const CouinaudSegments found = parted(patient.tree, patient.liver);
    ASSERT_EQ(found.branches.size(), patient.segment.size());
    for (std::size_t s = 0; s < patient.segment.size(); ++s) {
        const Vec3 end = patient.tree.segments[s].points_mm.back();
        if (patient.segment[s] != 0) {
            EXPECT_EQ(found.branches[s].segment, patient.segment[s]) << end.transpose();
            EXPECT_GT(found.branches[s].confidence, 0.5) << end.transpose();
        }
        if (patient.tree.segments[s].parent < 0) {
            EXPECT_EQ(found.branches[s].segment, 0) << end.transpose();
        }
    }
    EXPECT_LT((found.frame.bifurcation_mm - patient.bifurcation_mm).norm(), 1e-9);
    EXPECT_EQ(found.frame.vein_known, (std::array<bool, 3>{veins, veins, veins}));
    EXPECT_EQ(found.frame.confluence_known, veins);
    EXPECT_LT(found.unsure_share, 0.1);
    for (const double volume : segment_volumes_ml(found.labels)) EXPECT_GT(volume, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Types, TextbookTest,
                         testing::Values(std::pair{PortalType::usual, true},
                                         std::pair{PortalType::usual, false},
                                         std::pair{PortalType::trifurcation, true},
                                         std::pair{PortalType::trifurcation, false},
                                         std::pair{PortalType::early_posterior, true},
                                         std::pair{PortalType::early_posterior, false}));

// Conservation: the segments' volumes are the liver's, and none has a voxel outside of it.
TEST(CouinaudSegments, PartTheWholeLiverAndNothingElse) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Phantom phantom = grown(seed);
        const CouinaudSegments found = parted(phantom.tree, phantom.liver);
        ASSERT_TRUE(same_grid(found.labels.grid, phantom.liver.grid));
        std::size_t voxels = 0;
        for (std::size_t i = 0; i < phantom.liver.voxels.size(); ++i) {
            ASSERT_EQ(found.labels.voxels[i] != 0, phantom.liver.voxels[i] != 0);
            ASSERT_LE(found.labels.voxels[i], 8);
            voxels += phantom.liver.voxels[i] != 0 ? 1 : 0;
        }
        const auto volumes = segment_volumes_ml(found.labels);
        EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0),
                    static_cast<double>(voxels) * phantom.liver.grid.spacing_mm.prod() / 1000.0,
                    1e-9);
    }
}

// Each piece of a segment holds a branch of that segment.
TEST(CouinaudSegments, HangTogetherWithTheirBranches) {
    const TextbookPatient patient = test::textbook_patient(PortalType::usual, true, liver());
    const CouinaudSegments found = parted(patient.tree, patient.liver);
    const Grid& grid = patient.liver.grid;
    for (int k = 1; k <= couinaud_count; ++k) {
        Mask one(grid);
        for (std::size_t i = 0; i < one.voxels.size(); ++i)
            one.voxels[i] = found.labels.voxels[i] == k ? 1 : 0;
        const Components pieces = connected_components(one, Connectivity::all26);
        std::set<std::uint32_t> with_branch;
        for (std::size_t s = 0; s < found.branches.size(); ++s) {
            if (found.branches[s].segment != k) continue;
            for (const Vec3& point : patient.tree.segments[s].points_mm) {
                const Vec3 at = grid.to_index(point);
                with_branch.insert(pieces.labels.at(static_cast<int>(std::lround(at.x())),
                                                    static_cast<int>(std::lround(at.y())),
                                                    static_cast<int>(std::lround(at.z()))));
            }
        }
        with_branch.erase(0);
        EXPECT_EQ(with_branch.size(), pieces.sizes.size()) << "segment " << k;
    }
}

VesselTree moved(VesselTree tree, const std::function<Vec3(const Vec3&)>& move, double scale) {
    for (VesselNode& node : tree.nodes) {
        node.position_mm = move(node.position_mm);
        node.radius_mm *= scale;
    }
    for (VesselSegment& segment : tree.segments) {
        for (Vec3& point : segment.points_mm) point = move(point);
        for (double& radius : segment.radii_mm) radius *= scale;
    }
    return tree;
}

TEST(CouinaudSegments, MoveAndGrowWithThePatient) {
    const TextbookPatient patient = test::textbook_patient(PortalType::usual, true, liver());
    const CouinaudSegments here = parted(patient.tree, patient.liver);
    Mask elsewhere = patient.liver;
    const Vec3 by(128.0, -64.0, 1024.0);
    elsewhere.grid.origin_mm += by;
    const auto shift = [&](const Vec3& p) { return Vec3(p + by); };
    EXPECT_EQ(parted(moved(patient.tree, shift, 1.0), elsewhere).labels.voxels, here.labels.voxels);
    Mask child = patient.liver;
    child.grid.origin_mm *= 0.5;
    child.grid.spacing_mm *= 0.5;
    const auto shrink = [](const Vec3& p) { return Vec3(0.5 * p); };
    const CouinaudSegments small = parted(moved(patient.tree, shrink, 0.5), child);
    EXPECT_EQ(small.labels.voxels, here.labels.voxels);
    EXPECT_NEAR(small.frame.scale, 0.5 * here.frame.scale, 1e-12);
}

// The same patient stored with every axis the other way round.
TEST(CouinaudSegments, DoNotDependOnTheOrderOfVoxels) {
    const TextbookPatient patient = test::textbook_patient(PortalType::usual, true, liver());
    const CouinaudSegments here = parted(patient.tree, patient.liver);
    const Grid& grid = patient.liver.grid;
    Mask turned(grid);
    turned.grid.direction = -Mat3::Identity();
    turned.grid.origin_mm = grid.to_mm(grid.dims[0] - 1, grid.dims[1] - 1, grid.dims[2] - 1);
    std::ranges::reverse_copy(patient.liver.voxels, turned.voxels.begin());
    const CouinaudSegments there = parted(patient.tree, turned);
    for (std::size_t s = 0; s < here.branches.size(); ++s)
        EXPECT_EQ(there.branches[s].segment, here.branches[s].segment);
    std::vector<std::uint8_t> back = there.labels.voxels;
    std::ranges::reverse(back);
    std::size_t other = 0;
    for (std::size_t i = 0; i < back.size(); ++i) other += back[i] != here.labels.voxels[i];
    EXPECT_LT(other, back.size() / 10000);  // rounding decides between equal ways
}

TEST(CouinaudSegments, AreTheSameOnFinerVoxels) {
    const TextbookPatient patient = test::textbook_patient(PortalType::usual, true, liver());
    const CouinaudSegments here = parted(patient.tree, patient.liver);
    const Mask fine = test::liver_of_phantom(1.7);
    const CouinaudSegments finer = parted(patient.tree, fine);
    for (std::size_t s = 0; s < here.branches.size(); ++s)
        EXPECT_EQ(finer.branches[s].segment, here.branches[s].segment);
    const auto coarse_ml = segment_volumes_ml(here.labels);
    const auto fine_ml = segment_volumes_ml(finer.labels);
    const double all = std::accumulate(fine_ml.begin(), fine_ml.end(), 0.0);
    for (int k = 0; k < couinaud_count; ++k)
        EXPECT_NEAR(coarse_ml[k], fine_ml[k], 0.01 * all) << "segment " << k + 1;
}

TEST(CouinaudSegments, AreTheSameBytesForAnyNumberOfThreads) {
    const Phantom phantom = grown(1);
    CouinaudSegments one, many;
    {
        const ThreadLimit limit(1);
        one = parted(phantom.tree, phantom.liver);
    }
    {
        const ThreadLimit limit(4);
        many = parted(phantom.tree, phantom.liver);
    }
    EXPECT_EQ(one.labels.voxels, many.labels.voxels);
    for (std::size_t s = 0; s < one.branches.size(); ++s)
        EXPECT_EQ(one.branches[s].confidence, many.branches[s].confidence);
}

// A file may hold one: the links of loops are no parents of the tree that is walked down.
TEST(CouinaudSegments, ATrunkBelowTheLinkOfALoopIsFound) {
    VesselTree tree = test::textbook_patient(PortalType::usual, true, liver()).tree;
    const int trunk = end_of_portal_trunk(tree);
    int root = trunk;
    while (tree.segments[root].parent >= 0) root = tree.segments[root].parent;
    tree.segments[root].closes_loop = true;
    const int below = end_of_portal_trunk(tree);
    EXPECT_GE(below, 0);
    EXPECT_FALSE(tree.segments[below].closes_loop);
    Job job;
    EXPECT_NO_THROW(couinaud_segments(tree, liver(), job));
}

TEST(CouinaudSegments, NeedALiverAndAPortalVein) {
    const TextbookPatient patient = test::textbook_patient(PortalType::usual, true, liver());
    Job job;
    EXPECT_FALSE(couinaud_segments(patient.tree, Mask(liver().grid), job).has_value());
    EXPECT_FALSE(couinaud_segments(patient.tree, Mask(), job).has_value());
    VesselTree hepatic = patient.tree;
    for (VesselSegment& segment : hepatic.segments) segment.system = VascularSystem::hepatic;
    EXPECT_FALSE(couinaud_segments(hepatic, liver(), job).has_value());
}

// A segment of which no branch was found is left out, not invented.
TEST(CouinaudSegments, AMissingBranchLeavesItsSegmentEmpty) {
    TextbookPatient patient = test::textbook_patient(PortalType::usual, true, liver());
    VesselGraph graph = to_graph(patient.tree);
    std::vector<std::uint8_t> removed;
    for (const int segment : patient.segment) removed.push_back(segment == 1 ? 1 : 0);
    remove_links(graph, removed);
    const VesselTree without = directed(graph, root_wishes(patient.tree));
    const auto volumes = segment_volumes_ml(parted(without, patient.liver).labels);
    EXPECT_EQ(volumes[0], 0.0);
    for (int k = 1; k < couinaud_count; ++k) EXPECT_GT(volumes[k], 0.0) << "segment " << k + 1;
}

}  // namespace
}  // namespace hepatica
